// SPDX-License-Identifier: MIT
#include "runtime/lod/pose_drift.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/tiny_assets.h"

namespace sinew::test {
namespace {

const double kEighthTurn = 2.0 * std::sin(3.14159265358979 / 8.0);  // movement of a point one metre away

glm::quat turned(float degrees) { return glm::angleAxis(glm::radians(degrees), glm::vec3(0, 0, 1)); }

/// A joint that moves 2 m in one second while it turns by 90 degrees and grows to three times its size.
Animation moving_root(Interpolation translation = Interpolation::linear) {
  BoneAnimation root;
  root.joint = 0;
  root.translation = track_of<glm::vec3>(translation, {0, 1}, {glm::vec3(0), glm::vec3(2, 0, 0)});
  root.rotation = track_of<glm::quat>(Interpolation::linear, {0, 1}, {turned(0), turned(90)});
  root.scale = track_of<glm::vec3>(Interpolation::linear, {0, 1}, {glm::vec3(1), glm::vec3(3)});
  return animation_of({root});
}

TEST(pose_drift, is_how_far_a_joint_strays_from_the_middle_of_a_piece) {
  const Skeleton skeleton = chain_skeleton(1);
  const Animation animation = moving_root();
  PoseDrift drift(skeleton, animation);
  drift.bound_interval(0.0, 1.0);
  EXPECT_NEAR(translation_of(drift.middle()[0]).x, 1.0, 1e-6);
  EXPECT_NEAR(drift.drifts()[0].fixed_m, 1.0, 1e-6);
  EXPECT_NEAR(drift.drifts()[0].per_metre, kEighthTurn * 3.0 + 1.0, 1e-6) << "dR times the largest scale, and dS";
  drift.bound_interval(0.0, 0.5);
  EXPECT_NEAR(translation_of(drift.middle()[0]).x, 0.5, 1e-6);
  EXPECT_NEAR(drift.drifts()[0].fixed_m, 0.5, 1e-6);
}

TEST(pose_drift, a_fixed_matrix_carries_that_of_its_parent_and_has_none_of_its_own) {
  Skeleton skeleton = chain_skeleton(2);
  skeleton.fixed_matrices = {affine_from(Mat3<float>(2.0f), glm::vec3(0, 3, 0))};
  skeleton.fixed_matrix_of[1] = 0;
  const Animation animation = moving_root();
  PoseDrift drift(skeleton, animation);
  drift.bound_interval(0.0, 1.0);
  const Drift& root = drift.drifts()[0];
  EXPECT_NEAR(drift.drifts()[1].fixed_m, root.fixed_m + 3.0 * root.per_metre, 1e-6);
  EXPECT_NEAR(drift.drifts()[1].per_metre, 2.0 * root.per_metre, 1e-6);
}

TEST(pose_drift, a_child_that_rests_strays_with_its_parent) {
  Skeleton skeleton = chain_skeleton(2);
  skeleton.rest[1].translation = glm::vec3(0, 0.5f, 0);
  const Animation animation = moving_root();
  PoseDrift drift(skeleton, animation);
  drift.bound_interval(0.0, 1.0);
  const Drift& root = drift.drifts()[0];
  EXPECT_NEAR(drift.drifts()[1].fixed_m, root.fixed_m + 0.5 * root.per_metre, 1e-6);
  EXPECT_NEAR(drift.drifts()[1].per_metre, root.per_metre, 1e-6);
}

TEST(pose_drift, a_cubic_may_stray_farther_than_at_the_four_places) {
  const Skeleton skeleton = chain_skeleton(1);
  Animation animation = moving_root();
  animation.bones[0].translation = track_of<glm::vec3>(
      Interpolation::cubic_spline, {0, 1},
      {glm::vec3(0), glm::vec3(0), glm::vec3(2, 0, 0), glm::vec3(2, 0, 0), glm::vec3(2, 0, 0), glm::vec3(0)});
  PoseDrift drift(skeleton, animation);
  drift.bound_interval(0.0, 1.0);
  EXPECT_NEAR(drift.drifts()[0].fixed_m, 1.64, 1e-6) << "a straight line here, which is not asked";
}

TEST(pose_drift, a_cubic_scale_alone_may_stray_farther_too) {
  const Skeleton skeleton = chain_skeleton(1);
  Animation animation;
  animation.bones.push_back({.joint = 0});
  animation.bones[0].scale =
      track_of<glm::vec3>(Interpolation::cubic_spline, {0, 1},
                          {glm::vec3(0), glm::vec3(1), glm::vec3(2), glm::vec3(2), glm::vec3(3), glm::vec3(0)});
  PoseDrift drift(skeleton, animation);
  drift.bound_interval(0.0, 1.0);
  EXPECT_NEAR(drift.drifts()[0].per_metre, 1.64 * std::sqrt(3.0), 1e-6) << "1 at the places that are looked at";
}

}  // namespace
}  // namespace sinew::test
