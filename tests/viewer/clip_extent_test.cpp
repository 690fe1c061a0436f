// SPDX-License-Identifier: MIT
#include "viewer/app/clip_extent.h"

#include <cmath>

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "runtime/plan/run_plan.h"
#include "tests/viewer/flyer.h"

namespace sinew::viewer {
namespace {

TEST(clip_extent, reach_as_far_as_the_clip_and_are_as_large_as_one_pose) {
  const Scene scene = flyer(true);
  const ClipExtent bounds = clip_extent(scene, 0);
  EXPECT_NEAR(bounds.reached.lower.x, 0.0f, 1e-5f);
  EXPECT_GT(bounds.reached.upper.x, 10.0f);  // poses are sampled: the farthest point may lie between two of them
  EXPECT_LE(bounds.reached.upper.x, 11.0f + 1e-5f);
  EXPECT_NEAR(glm::length(bounds.largest.upper - bounds.largest.lower), std::sqrt(2.0f), 1e-4f);
}

TEST(clip_extent, are_as_large_as_the_largest_pose_alone_wherever_it_is) {
  Scene scene = flyer(true);
  auto& scale = scene.animations[0].bones[0].scale;
  scale.times_s = {0.0f, 3.0f};
  scale.values = {{1, 1, 1}, {5, 5, 5}};
  scene.clips.clear();
  finish_scene(scene);
  const ClipExtent bounds = clip_extent(scene, 0);
  EXPECT_NEAR(bounds.largest.lower.x, 4.0f, 1e-4f) << "it ends there";
  EXPECT_NEAR(bounds.largest.upper.x, 9.0f, 1e-4f);
  EXPECT_NEAR(bounds.largest.upper.y - bounds.largest.lower.y, 5.0f, 1e-4f);
}

TEST(clip_extent, of_no_clip_are_those_of_the_rest_pose) {
  const Scene scene = flyer(true);
  const ClipExtent bounds = clip_extent(scene, kNone);
  EXPECT_EQ(bounds.reached.lower, glm::vec3(0, 3, 0));
  EXPECT_EQ(bounds.reached.upper, glm::vec3(1, 4, 0));
}

TEST(clip_extent, is_not_that_of_what_is_not_shown) {
  const Scene scene = flyer(true);
  const Plan plan = compile_plan(lend(scene), {});
  FrameBuffer buffer(plan);
  ASSERT_EQ(run_plan(plan, {}, buffer), ErrorCode::ok);
  for (const bool visible : {true, false}) {
    FrameResult frame = buffer.result();
    std::vector<InstanceResult> instances(frame.instances.begin(), frame.instances.end());
    instances[0].visible = visible;
    frame.instances = instances;
    Outline outline;
    outline.add(scene, frame, {glm::vec3(-9.0f), glm::vec3(9.0f)});
    EXPECT_EQ(bounds_of(scene, frame).empty(), !visible);
    EXPECT_EQ(outline.points().empty(), !visible);
  }
}

TEST(clip_extent, follow_the_joints_where_nothing_is_drawn) {
  const Scene scene = flyer(false);
  const ClipExtent moving = clip_extent(scene, 0);
  EXPECT_GT(moving.reached.upper.x, 9.0f);
  EXPECT_GT(moving.largest.upper.x - moving.largest.lower.x, 9.0f);  // a point has no size, but its path has
  const ClipExtent resting = clip_extent(scene, kNone);
  EXPECT_GT(glm::length(resting.reached.upper - resting.reached.lower), 0.0f);
  EXPECT_TRUE(clip_extent(Scene{}, kNone).reached.empty());
}

}  // namespace
}  // namespace sinew::viewer
