// SPDX-License-Identifier: MIT
#include "runtime/playback/blend_curves.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace sinew {
namespace {

template <class V>
std::array<CurveKey<V>, 1> constant(const V& value) {
  return {CurveKey<V>{0.0f, CurveStep::hold, value}};
}

TEST(blend_curves, a_mean_has_the_rest_value_in_place_of_missing_weight) {
  const auto one = constant(1.0f), five = constant(5.0f);
  const auto mean = [&](float a, float b) {
    const CurveLayer<float> layers[] = {{one, 0.0, a}, {five, 0.0, b}};
    return blend_curves<float>(layers, CurveBlend::mean, 10.0f);
  };
  EXPECT_FLOAT_EQ(mean(0.25f, 0.25f), 0.25f * 1 + 0.25f * 5 + 0.5f * 10);
  EXPECT_FLOAT_EQ(mean(0.5f, 0.5f), 3.0f);
  EXPECT_FLOAT_EQ(mean(1.0f, 3.0f), 4.0f) << "normalised above 1";
  EXPECT_EQ(mean(0.0f, 0.0f), 10.0f);
}

TEST(blend_curves, clips_without_the_curve_do_not_count) {
  const auto five = constant(5.0f);
  const CurveLayer<float> layers[] = {{{}, 0.0, 1.0f}, {five, 0.0, 1.0f}};
  EXPECT_EQ(blend_curves<float>(layers, CurveBlend::mean, 0.0f), 5.0f);
  EXPECT_EQ(blend_curves<float>(layers, CurveBlend::heaviest, 0.0f), 5.0f);
}

TEST(blend_curves, sums_and_the_heaviest_follow_their_equations) {
  const auto one = constant(glm::vec3(1, 0, 0)), five = constant(glm::vec3(0, 5, 0));
  const CurveLayer<glm::vec3> layers[] = {{one, 0.0, 0.5f}, {five, 0.0, 2.0f}};
  EXPECT_EQ(blend_curves<glm::vec3>(layers, CurveBlend::sum, glm::vec3(0, 0, 1)), glm::vec3(0.5f, 10, 1));
  EXPECT_EQ(blend_curves<glm::vec3>(layers, CurveBlend::heaviest, glm::vec3(0)), glm::vec3(0, 5, 0));
}

TEST(blend_curves, rotations_of_both_signs_blend_along_the_short_arc) {
  const glm::quat rest(1, 0, 0, 0), turned(std::cos(0.2f), std::sin(0.2f), 0, 0);
  const auto one = constant(turned), other = constant(-turned);
  const CurveLayer<glm::quat> layers[] = {{one, 0.0, 0.5f}, {other, 0.0, 0.5f}};
  const glm::quat mean = blend_curves<glm::quat>(layers, CurveBlend::mean, rest);
  EXPECT_NEAR(mean.w, turned.w, 1e-6f);
  EXPECT_NEAR(mean.x, turned.x, 1e-6f);
}

TEST(blend_curves, a_flag_needs_half_of_the_weight) {
  const auto yes = constant(true), no = constant(false);
  const auto mean = [&](float for_it, float against, bool rest) {
    const CurveLayer<bool> layers[] = {{yes, 0.0, for_it}, {no, 0.0, against}};
    return blend_curves<bool>(layers, CurveBlend::mean, rest);
  };
  EXPECT_TRUE(mean(0.5f, 0.5f, false));
  EXPECT_FALSE(mean(0.49f, 0.51f, false));
  EXPECT_TRUE(mean(0.2f, 0.4f, true)) << "the rest value has the missing weight";
  EXPECT_FALSE(mean(1.0f, 2.0f, true));
}

}  // namespace
}  // namespace sinew
