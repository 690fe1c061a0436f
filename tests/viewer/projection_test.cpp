// SPDX-License-Identifier: MIT
#include "viewer/passes/projection.h"

#include <gtest/gtest.h>

#include "tests/viewer/stored_depth.h"

namespace sinew::viewer {
namespace {

using V4 = Vec4<double>;

V4 project(const Mat4<double>& m, double x, double y, double z) {
  const V4 clip = m * V4(x, y, z, 1);
  return clip / clip.w;
}

const double kNear = 0.1, kFar = 500;

void expect_range(DepthMapping mapping, double at_near, double at_far) {
  for (const double facing : {-1.0, 1.0}) {
    const auto frame = perspective_frame(FrustumT<double>{-0.1, 0.3, -0.05, 0.2, kNear}, facing);
    const auto m = with_depth(frame, mapping, kNear, kFar);
    const V4 corner = project(m, 0.3, 0.2, facing * kNear);
    EXPECT_NEAR(corner.x, 1, 1e-14);
    EXPECT_NEAR(corner.y, 1, 1e-14);
    EXPECT_NEAR(corner.z, at_near, 1e-12);
    EXPECT_NEAR(project(m, -0.1, -0.05, facing * kNear).x, -1, 1e-14);
    EXPECT_NEAR(project(m, 0, 0, facing * kFar).z, at_far, 1e-12);
    const auto infinite = with_infinite_depth(frame, mapping, kNear);
    EXPECT_NEAR(project(infinite, 0, 0, facing * kNear).z, at_near, 1e-12);
    EXPECT_NEAR(project(infinite, 0, 0, facing * 1e12).z, at_far, 1e-9);
  }
  const auto box = orthographic(ViewBoxT<double>{-2, 3, -1, 4, -kNear, -kFar}, mapping);
  EXPECT_NEAR(project(box, 3, 4, -kNear).x, 1, 1e-14);
  EXPECT_NEAR(project(box, -2, -1, -kNear).y, -1, 1e-14);
  EXPECT_NEAR(project(box, 0, 0, -kNear).z, at_near, 1e-12);
  EXPECT_NEAR(project(box, 0, 0, -kFar).z, at_far, 1e-12);
}

TEST(projection, gl_depth_runs_from_minus_one_to_one) { expect_range(DepthMapping::gl, -1, 1); }
TEST(projection, zero_one_depth_runs_from_zero_to_one) { expect_range(DepthMapping::zero_one, 0, 1); }
TEST(projection, N30_reversed_depth_runs_from_one_to_zero) { expect_range(DepthMapping::reversed, 1, 0); }

TEST(projection, angle_and_rectangle_agree) {
  const auto a = perspective_frame(1.1, 1.7, -1.0), b = perspective_frame(symmetric_frustum(1.1, 1.7, kNear), -1.0);
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r) EXPECT_NEAR(a[c][r], b[c][r], 1e-15);
}

TEST(projection, near_times_far_may_overflow) {
  const auto frame = perspective_frame(1.0f, 1.0f, -1.0f);
  EXPECT_FLOAT_EQ(with_depth(frame, DepthMapping::gl, 1e20f, 1e21f)[3][2], -2e20f / 0.9f);
  EXPECT_FLOAT_EQ(with_depth(frame, DepthMapping::zero_one, 1e20f, 1e21f)[3][2], -1e20f / 0.9f);
  EXPECT_FLOAT_EQ(with_depth(frame, DepthMapping::reversed, 1e20f, 1e21f)[3][2], 1e20f / 0.9f);
}

TEST(depth, distance_survives_the_round_trip) {
  for (const DepthMapping mapping : {DepthMapping::gl, DepthMapping::zero_one, DepthMapping::reversed})
    for (const double d : {0.1, 0.5, 3.0, 100.0, 499.0}) {
      const auto terms = depth_terms(with_depth(perspective_frame(1.0, 1.0, -1.0), mapping, kNear, kFar));
      EXPECT_NEAR(distance_from_depth(terms, depth_from_distance(terms, d)) / d, 1, 1e-11);
    }
}

/// Distance between neighbouring float depths at 1 km.
double step_at_1_km(const Mat4<float>& m) {
  const auto terms = depth_terms(m);
  const float z = depth_from_distance(terms, 1000.0f);
  const DepthTermsT<double> exact{terms.a, terms.b};
  return std::abs(distance_from_depth(exact, double(std::nextafter(z, 2.0f))) - distance_from_depth(exact, double(z)));
}

TEST(depth, N30_reversed_infinite_depth_resolves_a_kilometre_four_orders_finer) {
  const auto frame = perspective_frame(1.0f, 1.0f, -1.0f);
  EXPECT_GT(step_at_1_km(with_depth(frame, DepthMapping::zero_one, 0.1f, 10000.0f)), 0.3);
  EXPECT_LT(step_at_1_km(with_infinite_depth(frame, DepthMapping::reversed, 0.1f)), 1.2e-4);
}

}  // namespace
}  // namespace sinew::viewer
