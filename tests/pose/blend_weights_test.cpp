// SPDX-License-Identifier: MIT
#include "runtime/pose/blend_poses.h"

#include <gtest/gtest.h>

#include <vector>

namespace sinew::test {
namespace {

std::vector<float> blended(std::vector<float> layer_weights, std::vector<float> first, const std::vector<float>& others,
                           const std::vector<float>& rest) {
  std::vector<BlendLayer> layers;
  for (const float w : layer_weights) layers.push_back({.pose = {}, .weight = w, .joint_weights = {}});
  blend_weights(layers, rest, first, others);
  return first;
}

TEST(blend_weights, rest_fills_up_what_the_layers_leave) {
  EXPECT_EQ(blended({0.25f}, {4.0f, 0.0f}, {}, {0.0f, 2.0f}), (std::vector<float>{1.0f, 1.5f}));
}

TEST(blend_weights, layers_heavier_than_one_are_averaged_without_rest) {
  EXPECT_EQ(blended({3.0f, 1.0f}, {1.0f, -1.0f}, {5.0f, 3.0f}, {100.0f, 100.0f}), (std::vector<float>{2.0f, 0.0f}));
}

TEST(blend_weights, the_order_of_layers_does_not_matter) {
  EXPECT_EQ(blended({0.1f, 0.7f, 0.15f}, {0.3f}, {0.9f, -0.2f}, {0.5f}),
            blended({0.15f, 0.1f, 0.7f}, {-0.2f}, {0.3f, 0.9f}, {0.5f}));
}

TEST(blend_weights, N26_what_cancels_to_almost_nothing_is_zero) {
  EXPECT_EQ(blended({0.5f, 0.5f}, {1e-25f}, {1e-26f}, {0.0f}), std::vector<float>{0.0f});
  EXPECT_NE(blended({0.5f, 0.5f}, {1e-15f}, {0.0f}, {0.0f}), std::vector<float>{0.0f});
}

}  // namespace
}  // namespace sinew::test
