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
