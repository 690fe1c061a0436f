// SPDX-License-Identifier: MIT
#include "runtime/library/clip_channels.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/animation/skeleton_signature.h"
#include "runtime/clip/clip_layout.h"
#include "tests/scenes/hand_scenes.h"

namespace sinew::test {
namespace {

using testing::ElementsAre;

std::vector<std::string> listed(const SharedArray<std::string>& names) { return {names.begin(), names.end()}; }

void animate(Scene& scene, const PropertyTarget& target, std::uint32_t count) {
  const WeightTrack values{is_flag(target.kind) ? Interpolation::step : Interpolation::linear,
                           {0.0f},
                           std::vector<float>(count, 0.5f),
                           count};
  scene.animations[0].properties.push_back({target, values});
}

TEST(clip_channels, morph_weights_have_the_names_of_their_mesh_and_target) {
  Scene scene = face_scene();
  EXPECT_THAT(listed(clip_channels(scene).weights), ElementsAre("face/lift", "face/spread"));
  scene.meshes[0].target_names = {"lift", ""};
  EXPECT_THAT(listed(clip_channels(scene).weights), ElementsAre("face/lift", "face/1"));
  scene.meshes[0].target_names.clear();
  EXPECT_THAT(listed(clip_channels(scene).weights), ElementsAre("face/0", "face/1"));
  scene.meshes[0].name.clear();
  const std::uint32_t joint = scene.instances[0].joint;
  scene.skeleton.names.assign(scene.skeleton.joint_count(), "other");
  scene.skeleton.names[joint] = "head";
  EXPECT_THAT(listed(clip_channels(scene).weights), ElementsAre("head/0", "head/1"));
  scene.skeleton.names[joint].clear();
  EXPECT_THAT(listed(clip_channels(scene).weights), ElementsAre("", ""));
  scene.skeleton.names.clear();
  EXPECT_THAT(listed(clip_channels(scene).weights), ElementsAre("", ""));
}

TEST(clip_channels, properties_have_the_names_of_their_thing_and_component) {
  Scene scene = arm_scene();
  scene.materials = {Material{.name = "skin"}, Material{}};
  scene.cameras.push_back({.name = "eye"});
  scene.lights.push_back({.name = "sun"});
  animate(scene, {PropertyKind::node_visible, 2}, 1);
  animate(scene, {PropertyKind::camera_fov_y, 0}, 1);
  animate(scene, {PropertyKind::light_color, 0}, 3);
  animate(scene, {PropertyKind::emissive, 0}, 3);
  animate(scene, {PropertyKind::texture_offset, 0, TextureSlot::normal}, 2);
  animate(scene, {PropertyKind::metallic, 1}, 1);
  finish_scene(scene);
  EXPECT_THAT(listed(clip_channels(scene).numbers),
              ElementsAre("joint lower/visible", "camera eye/fov_y", "light sun/color/0", "light sun/color/1",
                          "light sun/color/2", "", "material skin/emissive/0", "material skin/emissive/1",
                          "material skin/emissive/2", "material skin/normal_texture/offset/0",
                          "material skin/normal_texture/offset/1"));
}

TEST(clip_channels, every_property_and_every_texture_has_its_name) {
  Scene scene;
  scene.cameras.push_back({.name = "eye"});
  scene.lights.push_back({.name = "sun"});
  scene.materials.push_back({.name = "skin"});
  const auto name = [&](PropertyKind kind, TextureSlot slot = TextureSlot::base_color) {
    return property_name(scene, {kind, 0, slot});
  };
  std::vector<std::string> names;
  for (auto kind = PropertyKind::camera_fov_y; kind <= PropertyKind::alpha_cutoff;
       kind = static_cast<PropertyKind>(static_cast<int>(kind) + 1))
    names.push_back(name(kind));
  EXPECT_THAT(
      names,
      ElementsAre("camera eye/fov_y", "camera eye/aspect", "camera eye/half_width", "camera eye/half_height",
                  "camera eye/near", "camera eye/far", "light sun/color", "light sun/intensity", "light sun/range",
                  "light sun/inner_cone", "light sun/outer_cone", "material skin/base_color", "material skin/metallic",
                  "material skin/roughness", "material skin/normal_scale", "material skin/occlusion_strength",
                  "material skin/emissive", "material skin/emissive_strength", "material skin/alpha_cutoff"));
  const std::pair<TextureSlot, std::string> slots[] = {{TextureSlot::base_color, "base_color"},
                                                       {TextureSlot::metallic_roughness, "metallic_roughness"},
                                                       {TextureSlot::normal, "normal"},
                                                       {TextureSlot::occlusion, "occlusion"},
                                                       {TextureSlot::emissive, "emissive"}};
  for (const auto& [slot, texture] : slots) {
    EXPECT_EQ(name(PropertyKind::texture_offset, slot), "material skin/" + texture + "_texture/offset");
    EXPECT_EQ(name(PropertyKind::texture_rotation, slot), "material skin/" + texture + "_texture/rotation");
    EXPECT_EQ(name(PropertyKind::texture_scale, slot), "material skin/" + texture + "_texture/scale");
  }
}

TEST(clip_channels, joints_have_their_own_names_and_the_signature_of_their_skeleton) {
  Scene scene = arm_scene();
  const ClipChannels channels = clip_channels(scene);
  EXPECT_THAT(listed(channels.joints), ElementsAre("upper", "holder", "lower"));
  EXPECT_EQ(channels.signature, skeleton_signature(scene.skeleton));
  EXPECT_EQ(channels.rest.pose, scene.clips[0].layout().base_pose.rest()) << "shared with the clips";
  scene.skeleton.names.clear();
  EXPECT_THAT(listed(clip_channels(scene.skeleton).joints), ElementsAre("", "", ""));
}

}  // namespace
}  // namespace sinew::test
