// SPDX-License-Identifier: MIT
#include "runtime/model/pose_corrective.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "tests/scenes/pose_samples.h"

namespace sinew {
namespace {

constexpr float kNotANumber = std::numeric_limits<float>::quiet_NaN();

TEST(pose_corrective, every_broken_rule_is_found) {
  const struct {
    const char* what;
    std::function<void(PoseSamples&)> damage;
    ErrorCode expected;
  } cases[] = {
      {"no driver", [](PoseSamples& s) { s.drivers.clear(); }, ErrorCode::size_mismatch},
      {"no sample",
       [](PoseSamples& s) {
         s.rotations.clear();
         s.values.clear();
       },
       ErrorCode::size_mismatch},
      {"no weight",
       [](PoseSamples& s) {
         s.weights.clear();
         s.values.clear();
       },
       ErrorCode::size_mismatch},
      {"half a sample",
       [](PoseSamples& s) {
         s.drivers.resize(2);
         s.rotations.pop_back();
       },
       ErrorCode::size_mismatch},
      {"value missing", [](PoseSamples& s) { s.values.pop_back(); }, ErrorCode::size_mismatch},
      {"value not finite", [](PoseSamples& s) { s.values[2] = kNotANumber; }, ErrorCode::not_finite},
      {"rotation not finite", [](PoseSamples& s) { s.rotations[1].y = kNotANumber; }, ErrorCode::not_finite},
      {"rotation of no length",
       [](PoseSamples& s) {
         s.rotations[1] = {0, 0, 0, 0};
       },
       ErrorCode::not_finite},
      {"axis of no length", [](PoseSamples& s) { s.drivers[0].axis = {}; }, ErrorCode::not_finite},
      {"weight not finite", [](PoseSamples& s) { s.drivers[0].weight = kNotANumber; }, ErrorCode::not_finite},
      {"weights with no finite sum",
       [](PoseSamples& s) {
         s.rotations.resize(2 * s.rotations.size(), s.rotations[0]);
         s.drivers.assign(2, s.drivers[0]);
         for (PoseDriver& driver : s.drivers) driver.weight = 3e38f;
       },
       ErrorCode::not_finite},
      {"no driver counts", [](PoseSamples& s) { s.drivers[0].weight = 0; }, ErrorCode::not_finite},
      {"negative weight", [](PoseSamples& s) { s.drivers[0].weight = -1; }, ErrorCode::unsupported},
      {"no radius", [](PoseSamples& s) { s.radius_rad = 0; }, ErrorCode::unsupported},
      {"infinite radius", [](PoseSamples& s) { s.radius_rad = 1 / 0.0f; }, ErrorCode::not_finite},
      {"negative regularisation", [](PoseSamples& s) { s.regularisation = -1; }, ErrorCode::unsupported},
      {"a pose twice", [](PoseSamples& s) { s.rotations[1] = -s.rotations[2]; }, ErrorCode::coincident_poses},
      {"nearly a pose twice",
       [](PoseSamples& s) {
         s.rotations[1] = s.rotations[2];
         s.rotations[1].w *= 1 + 1e-7f;
       },
       ErrorCode::coincident_poses},
      {"tail without poses for it", [](PoseSamples& s) { s.tail = PolynomialTail::affine; }, ErrorCode::rank_deficient},
      {"one pose without tail",
       [](PoseSamples& s) {
         test::keep_samples(s, 1);
         s.kernel = RadialKernel::linear;
       },
       ErrorCode::rank_deficient},
      {"far too wide", [](PoseSamples& s) { s.radius_rad = 1e5f; }, ErrorCode::rank_deficient},
  };
  EXPECT_TRUE(solve_corrective(test::hinge_samples()).has_value());
  for (const auto& c : cases) {
    PoseSamples samples = test::hinge_samples();
    c.damage(samples);
    const auto solved = solve_corrective(samples);
    ASSERT_FALSE(solved.has_value()) << c.what;
    EXPECT_EQ(solved.error(), c.expected) << c.what;
  }
}

TEST(pose_corrective, a_driver_that_does_not_count_makes_poses_coincide) {
  PoseSamples samples = test::hinge_samples();
  samples.drivers[0].measure = RotationMeasure::swing;
  samples.drivers[0].axis = {0, 0, 1};  // the axis of the hinge, which never swings
  const auto solved = solve_corrective(samples);
  ASSERT_FALSE(solved.has_value());
  EXPECT_EQ(solved.error(), ErrorCode::coincident_poses);
}

TEST(pose_corrective, regularisation_takes_poses_that_coincide) {
  PoseSamples samples = test::hinge_samples();
  samples.rotations[1] = -samples.rotations[2];
  samples.regularisation = 1e-4f;
  const auto solved = solve_corrective(samples);
  ASSERT_TRUE(solved.has_value());
  for (const double c : solved->coefficients) EXPECT_TRUE(std::isfinite(c) && std::abs(c) < 1e5);
}

TEST(pose_corrective, indices_are_held_to_the_scene) {
  auto solved = solve_corrective(test::hinge_samples());
  ASSERT_TRUE(solved.has_value());
  EXPECT_EQ(check(*solved, 2, 2), ErrorCode::ok);
  EXPECT_EQ(check(*solved, 1, 2), ErrorCode::index_out_of_range);
  EXPECT_EQ(check(*solved, 2, 1), ErrorCode::index_out_of_range);
  solved->coefficients[0] = std::numeric_limits<double>::infinity();
  EXPECT_EQ(check(*solved, 2, 2), ErrorCode::not_finite);
  solved->coefficients.pop_back();
  EXPECT_EQ(check(*solved, 2, 2), ErrorCode::size_mismatch);
}

}  // namespace
}  // namespace sinew
