// SPDX-License-Identifier: MIT
#include "runtime/animation/track.h"

#include <gtest/gtest.h>

#include <limits>

#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
constexpr float kInf = std::numeric_limits<float>::infinity();
constexpr auto kLinear = Interpolation::linear;
constexpr auto kCubic = Interpolation::cubic_spline;

Vec3Track vectors(Interpolation interpolation, std::vector<float> times, std::size_t value_count) {
  return {interpolation, std::move(times), std::vector<glm::vec3>(value_count, glm::vec3(1))};
}

TEST(track, G08_G09_G13_G14_G16_rejections_name_the_broken_rule) {
  const struct {
    const char* what;
    Vec3Track track;
    ErrorCode expected;
  } cases[] = {
      {"two keys", vectors(kLinear, {0, 1}, 2), ErrorCode::ok},
      {"one linear key is a constant", vectors(kLinear, {3}, 1), ErrorCode::ok},
      {"one cubic key", vectors(kCubic, {3}, 3), ErrorCode::too_few_keys},
      {"two cubic keys", vectors(kCubic, {3, 4}, 6), ErrorCode::ok},
      {"no keys", vectors(kLinear, {}, 0), ErrorCode::too_few_keys},
      {"a value is missing", vectors(kLinear, {0, 1, 2}, 2), ErrorCode::size_mismatch},
      {"cubic values without tangents", vectors(kCubic, {0, 1}, 2), ErrorCode::size_mismatch},
      {"equal times are a jump", vectors(kLinear, {0, 1, 1, 2}, 4), ErrorCode::ok},
      {"decreasing times", vectors(kLinear, {0, 2, 1}, 3), ErrorCode::times_not_increasing},
      {"negative time", vectors(kLinear, {-1, 0}, 2), ErrorCode::times_not_increasing},
      {"NaN time", vectors(kLinear, {0, kNan}, 2), ErrorCode::not_finite},
      {"infinite time", vectors(kLinear, {0, kInf}, 2), ErrorCode::not_finite},
      {"squad of vectors", vectors(Interpolation::squad, {0, 1}, 2), ErrorCode::unsupported},
  };
  for (const auto& c : cases) EXPECT_EQ(check(c.track), c.expected) << c.what;
}

TEST(track, G14_any_component_that_is_not_finite_is_found) {
  for (int component = 0; component < 4; ++component)
    for (const float bad : {kNan, kInf, -kInf}) {
      QuatTrack track{kLinear, {0, 1}, std::vector<glm::quat>(2, quat_identity<float>())};
      EXPECT_EQ(check(track), ErrorCode::ok);
      track.values[1][component] = bad;
      EXPECT_EQ(check(track), ErrorCode::not_finite);
    }
}

TEST(track, G52_rotation_keys_have_the_length_that_their_interpolation_needs) {
  for (const Interpolation kind : {Interpolation::step, kLinear, Interpolation::squad})
    for (const float length : {0.0f, 0.99f, 1.01f, 2.0f, 1e30f}) {
      QuatTrack track{kind, {0, 1}, std::vector<glm::quat>(2, glm::quat(0.6f, 0.0f, 0.8f, 0.0f))};
      EXPECT_EQ(check(track), ErrorCode::ok);
      track.values[1] = track.values[1] * length;
      EXPECT_EQ(check(track), ErrorCode::not_normalised) << length;
    }
  // A cubic curve is normalised, so its values need not be unit. Their squared length must be a normal float.
  QuatTrack cubic{kCubic, {0, 1}, std::vector<glm::quat>(6, glm::quat(0, 0, 0, 0))};
  EXPECT_EQ(check(cubic), ErrorCode::not_normalised);
  for (const float length : {1e-9f, 1.0f, 1e14f}) {
    cubic.values[1] = cubic.values[4] = glm::quat(0.6f, 0.0f, 0.8f, 0.0f) * length;
    EXPECT_EQ(check(cubic), ErrorCode::ok) << length;
  }
  cubic.values[4] = cubic.values[4] * 1e3f;
  EXPECT_EQ(check(cubic), ErrorCode::not_normalised);
}

TEST(track, G19_weights_are_frame_major_with_all_targets_per_key) {
  WeightTrack track{kLinear, {0, 1}, std::vector<float>(6), 3};
  EXPECT_EQ(check(track), ErrorCode::ok);
  track.target_count = 2;
  EXPECT_EQ(check(track), ErrorCode::size_mismatch);
  track = {kCubic, {0, 1}, std::vector<float>(18), 3};
  EXPECT_EQ(check(track), ErrorCode::ok);
  track.values.pop_back();
  EXPECT_EQ(check(track), ErrorCode::size_mismatch);
  EXPECT_EQ(check(WeightTrack{Interpolation::squad, {0, 1}, std::vector<float>(2), 1}), ErrorCode::unsupported);
  EXPECT_EQ(check(WeightTrack{kLinear, {0}, {kNan}, 1}), ErrorCode::not_finite);
}

}  // namespace
}  // namespace sinew
