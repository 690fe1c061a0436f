// SPDX-License-Identifier: MIT
#include "viewer/app/camera/camera_pose.h"

#include <gtest/gtest.h>

#include "runtime/base/same_bits.h"
#include "tests/scenes/hand_scenes.h"
#include "tests/scenes/random_scene.h"
#include "viewer/app/camera/file_camera.h"
#include "viewer/app/camera/frustum_culling.h"

namespace sinew::viewer {
namespace {

bool same_view(const View& a, const View& b) {
  return same_bits(a.view_from_world, b.view_from_world) && a.fov_y_rad == b.fov_y_rad && a.near_m == b.near_m &&
         a.far_m == b.far_m;
}

TEST(camera_pose, N27_is_what_the_whole_pose_says) {
  for (std::uint32_t seed = 0; seed < 10; ++seed) {
    Scene scene = test::random_scene(seed);
    for (std::uint32_t joint = 0; joint < 14; joint += 3)
      scene.cameras.push_back(
          {.name = "camera", .joint = joint, .fov_y_rad = 0.5f + 0.01f * static_cast<float>(joint)});
    const Plan plan = compile_plan(lend(scene), {});
    FrameBuffer frame(plan);
    for (std::uint32_t c = 0; c < scene.cameras.size(); ++c) {
      CameraPose pose(scene, c);
      EXPECT_EQ(pose.camera(), c);
      for (const std::uint32_t clip : {0u, 1u, kNone}) {
        const ClipLayer layer{clip, 0.3 + 0.1 * seed};
        FrameInput input;
        if (clip != kNone) input.layers = {&layer, 1};
        ASSERT_EQ(run_plan(plan, input, frame), ErrorCode::ok);
        const View expected = view_of_camera(scene.cameras[c], frame.result().model[scene.cameras[c].joint], 1.5, {});
        EXPECT_TRUE(same_view(pose.at(clip, layer.time_s, 1.5, {}), expected)) << "seed " << seed << " camera " << c;
      }
    }
  }
}

TEST(camera_pose, moves_where_a_clip_moves_its_joint_or_one_above) {
  Scene scene = test::arm_scene();  // its clip moves joint 2, below joint 0
  for (std::uint32_t joint = 0; joint < 3; ++joint) scene.cameras.push_back({.name = "camera", .joint = joint});
  EXPECT_FALSE(CameraPose(scene, 0).moves());
  EXPECT_FALSE(CameraPose(scene, 1).moves());
  EXPECT_TRUE(CameraPose(scene, 2).moves());
}

TEST(camera_pose, has_the_angle_that_the_clip_gives_it) {
  Scene scene = test::arm_scene();
  scene.cameras.push_back({.name = "zooms", .joint = 1});
  WeightTrack zoom;
  zoom.interpolation = Interpolation::linear;
  zoom.target_count = 1;
  zoom.times_s = {0.0f, 1.0f};
  zoom.values = {0.5f, 1.0f};
  scene.animations[0].properties.push_back({{PropertyKind::camera_fov_y, 0}, zoom});
  scene.clips.clear();
  finish_scene(scene);
  CameraPose pose(scene, 0);
  EXPECT_TRUE(pose.moves());
  EXPECT_NEAR(pose.at(0, 0.5, 1.0, {}).fov_y_rad, 0.75, 1e-6);
  EXPECT_NEAR(pose.at(0, 1.0, 1.0, {}).fov_y_rad, 1.0, 1e-6);
}

TEST(camera_pose, P14_what_a_camera_of_the_file_does_not_see_is_known_before_the_pose) {
  Scene scene = test::arm_scene();
  scene.cameras.push_back({.name = "aside", .joint = 1, .fov_y_rad = 0.3f});  // five metres to the right, along -z
  Needs needs;
  needs.out.bounds = true;
  FrustumCulling culling(scene, needs);
  CameraPose pose(scene, 0);
  EXPECT_TRUE(culling.of(0, pose.at(0, 0.5, 1.0, {}), 1.0).every_instance);
  scene.skeleton.rest[1].translation = {0.0f, 1.0f, 5.0f};
  scene.clips.clear();  // they have the rest pose in them
  finish_scene(scene);
  CameraPose before_it(scene, 0);
  EXPECT_FALSE(culling.of(0, before_it.at(0, 0.5, 1.0, {}), 1.0).every_instance);
}

}  // namespace
}  // namespace sinew::viewer
