// SPDX-License-Identifier: MIT
#include "viewer/passes/render_options.h"

#include <gtest/gtest.h>
#include <glm/geometric.hpp>

#include "viewer/passes/frame_uniforms.h"

namespace sinew::viewer {
namespace {

const Aabb kBox{{-1.0f, 2.0f, -3.0f}, {3.0f, 4.0f, 1.0f}};  // half the diagonal is 3

TEST(ambient_occlusion_for, has_lengths_in_proportion_to_the_bounds) {
  const AmbientOcclusion ao = ambient_occlusion_for(kBox);
  EXPECT_FLOAT_EQ(ao.radius_m, 0.3f);
  EXPECT_FLOAT_EQ(ao.surface_epsilon_m, 0.006f);
  EXPECT_FLOAT_EQ(ao.fade_start_m, 0.12f);
  EXPECT_FLOAT_EQ(ao.fade_end_m, 0.6f);
  for (const Aabb& nothing : {Aabb{}, Aabb{{5, 5, 5}, {5, 5, 5}}})
    EXPECT_FLOAT_EQ(ambient_occlusion_for(nothing).radius_m, 0.1f) << "as of a box of half diagonal 1";
}

TEST(ground_for, lies_just_below_the_bounds_in_their_middle) {
  const Ground found = ground_for(kBox);
  EXPECT_EQ(found.bounds.lower, kBox.lower) << "what casts shadows";
  EXPECT_EQ(found.bounds.upper, kBox.upper);
  EXPECT_NEAR(glm::length(found.middle - glm::dvec3(1.0, 2.0 - 0.006, -1.0)), 0.0, 1e-6);
  EXPECT_FLOAT_EQ(found.radius_m, 9.0f);
  EXPECT_FLOAT_EQ(found.grid_step_m, 1.0f);
  EXPECT_EQ(found.look, GroundLook::none);
  EXPECT_EQ(ground_for({}).middle, glm::dvec3(0.0));
  EXPECT_FLOAT_EQ(ground_for({{0, 0, 0}, {0.02f, 0.0f, 0.0f}}).grid_step_m, 0.01f);
}

TEST(ground_is_seen, from_above_alone) {
  Ground ground;
  ground.middle = {-5.0, 1.0, 3.0};
  const auto seen_from = [&](const glm::dvec3& eye, bool parallel = false) {
    View view = look_at(eye, {0.0, 1.0, 0.0}, 0.8, 0.05);
    if (parallel) view.half_height_m = 1.0;
    return ground_is_seen(view, ground);
  };
  EXPECT_FALSE(seen_from({0, 9, 4})) << "it has no look";
  ground.look = GroundLook::grid;
  for (const bool parallel : {false, true}) {
    EXPECT_TRUE(seen_from({0, 1.1, 4}, parallel));
    EXPECT_FALSE(seen_from({0, 0.9, 4}, parallel));
    EXPECT_TRUE(seen_from({0, 2, -9}, parallel));
    EXPECT_FALSE(seen_from({9, -2, 9}, parallel));
  }
  View up = look_at({0, 9, 4}, {0, 12, 0}, 0.8, 0.05), down = look_at({0, -9, 4}, {0, -12, 0}, 0.8, 0.05);
  EXPECT_TRUE(ground_is_seen(up, ground)) << "the eye of a perspective is above it";
  EXPECT_FALSE(ground_is_seen(down, ground));
  up.half_height_m = down.half_height_m = 1.0;
  EXPECT_FALSE(ground_is_seen(up, ground)) << "a parallel view looks at it from below, wherever its eye is said to be";
  EXPECT_TRUE(ground_is_seen(down, ground));
}

TEST(render_options_for, have_lengths_of_the_bounds_and_depths_of_the_ball_around_them) {
  const RenderOptions options = render_options_for(kBox, {1.0, 3.0, 7.0});
  EXPECT_EQ(options.ao.radius_m, ambient_occlusion_for(kBox).radius_m);
  EXPECT_EQ(options.ground.middle, ground_for(kBox).middle);
  EXPECT_FLOAT_EQ(options.depth_range.nearest_m, 5.0f);
  EXPECT_FLOAT_EQ(options.depth_range.farthest_m, 11.0f);
  EXPECT_FLOAT_EQ(render_options_for({}, {0.0, 0.0, 5.0}).depth_range.farthest_m, 6.0f);
}

}  // namespace
}  // namespace sinew::viewer
