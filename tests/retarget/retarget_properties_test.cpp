// SPDX-License-Identifier: MIT
#include "runtime/retarget/retarget_properties.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

using testing::ElementsAre;

Scene with_materials(const std::vector<std::string>& names) {
  Scene scene;
  scene.skeleton = test::skeleton_of({kNone, 0});
  for (const std::string& name : names) scene.materials.emplace_back().name = name;
  return scene;
}

PropertyTrack track_of(PropertyKind kind, std::uint32_t index, float value) {
  return {{kind, index},
          {Interpolation::step, {0.0f}, std::vector<float>(component_count(kind), value), component_count(kind)}};
}

TEST(retarget_properties, follow_things_of_their_name_and_joints_that_follow_theirs) {
  const Scene from = with_materials({"skin", "glass", "cloth", ""}), to = with_materials({"cloth", "skin", "cloth"});
  Animation animation{"glow", 1.0, {}, {}};
  animation.properties = {
      track_of(PropertyKind::emissive, 0, 1.0f),       track_of(PropertyKind::roughness, 1, 2.0f),
      track_of(PropertyKind::texture_offset, 2, 3.0f), track_of(PropertyKind::metallic, 3, 4.0f),
      track_of(PropertyKind::node_visible, 0, 0.0f),   track_of(PropertyKind::node_visible, 1, 1.0f)};
  SkeletonMap map;
  map.joints.push_back({1, 0});
  Animation made;
  made.properties = {track_of(PropertyKind::metallic, 0, 0.0f)};
  EXPECT_THAT(retarget_properties(animation, map, from, to, made),
              ElementsAre("material glass/roughness", "material cloth/base_color_texture/offset",
                          "a property of a thing without a name", "joint joint1/visible"))
      << "two materials are called cloth";
  ASSERT_EQ(made.properties.size(), 2u);
  EXPECT_EQ(made.properties[0].target, (PropertyTarget{PropertyKind::emissive, 1}));
  EXPECT_THAT(made.properties[0].values.values, ElementsAre(1, 1, 1));
  EXPECT_EQ(made.properties[1].target, (PropertyTarget{PropertyKind::node_visible, 1}));
}

TEST(retarget_properties, cameras_and_lights_are_found_in_their_own_lists) {
  Scene from = with_materials({"lamp"}), to = with_materials({"lamp"});
  from.cameras = {{.name = "front"}, {.name = "lamp"}};
  to.cameras = {{.name = "back"}, {.name = "lamp"}, {.name = "front"}};
  from.lights = {{.name = "lamp"}};
  to.lights = {{.name = "sun"}, {.name = "moon"}, {.name = "star"}, {.name = "lamp"}};
  Animation animation{"", 1.0, {}, {}}, made;
  animation.properties = {track_of(PropertyKind::camera_fov_y, 0, 1.0f), track_of(PropertyKind::camera_far, 1, 1.0f),
                          track_of(PropertyKind::light_color, 0, 1.0f),
                          track_of(PropertyKind::light_outer_cone, 0, 1.0f),
                          track_of(PropertyKind::base_color, 0, 1.0f)};
  EXPECT_THAT(retarget_properties(animation, {}, from, to, made), ElementsAre());
  std::vector<std::uint32_t> indices;
  for (const PropertyTrack& track : made.properties) indices.push_back(track.target.index);
  EXPECT_THAT(indices, ElementsAre(2, 1, 3, 3, 0));
}

}  // namespace
}  // namespace sinew
