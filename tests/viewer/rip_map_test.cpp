// SPDX-License-Identifier: MIT
#include "viewer/upload/rip_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/reference/shade.h"
#include "tests/support/fixed_random.h"

namespace sinew::viewer {
namespace {

std::vector<std::uint8_t> noise(std::uint32_t width, std::uint32_t height) {
  test::FixedRandom random(11);
  std::vector<std::uint8_t> rgba(std::size_t{4} * width * height);
  for (std::uint8_t& code : rgba) code = static_cast<std::uint8_t>(random.in(0.0, 256.0));
  return rgba;
}

/// Mean of the texels that one texel of level (i, j) stands for, as a code before it is rounded.
double mean_code(const std::vector<std::uint8_t>& rgba, std::uint32_t width, std::uint32_t i, std::uint32_t j,
                 std::uint32_t x, std::uint32_t y, std::uint32_t channel, bool srgb) {
  const bool decoded = srgb && channel < 3;
  double sum = 0.0;
  for (std::uint32_t row = y << j; row < (y + 1) << j; ++row)
    for (std::uint32_t column = x << i; column < (x + 1) << i; ++column) {
      const double value = rgba[4 * (std::size_t{row} * width + column) + channel] / 255.0;
      sum += decoded ? reference::srgb_decoded(value) : value;
    }
  const double mean = sum / static_cast<double>((1u << i) * (1u << j));
  return 255.0 * (decoded ? reference::srgb_encoded(mean) : mean);
}

void expect_means(std::uint32_t width, std::uint32_t height, bool srgb) {
  const auto rgba = noise(width, height);
  const MipLevel map = rip_map(rgba, width, height, srgb);
  ASSERT_EQ(map.width, 2 * width);
  ASSERT_EQ(map.height, 2 * height);
  ASSERT_EQ(map.rgba.size(), 4 * rgba.size());
  for (std::uint32_t j = 0; height >> j > 0; ++j)
    for (std::uint32_t i = 0; width >> i > 0; ++i)
      for (std::uint32_t y = 0; y < height >> j; ++y)
        for (std::uint32_t x = 0; x < width >> i; ++x)
          for (std::uint32_t c = 0; c < 4; ++c) {
            const std::size_t column = 2 * width - 2 * (width >> i) + x, row = 2 * height - 2 * (height >> j) + y;
            ASSERT_NEAR(map.rgba[4 * (row * map.width + column) + c], mean_code(rgba, width, i, j, x, y, c, srgb),
                        0.501)
                << "level " << i << ' ' << j << ", texel " << x << ' ' << y << ", channel " << c;
          }
}

TEST(rip_map, every_texel_of_every_level_is_the_mean_of_what_it_stands_for_rounded_once) {
  for (const bool srgb : {false, true})
    for (const auto& [width, height] : {std::pair(16u, 16u), {32u, 4u}, {1u, 8u}, {1u, 1u}, {13u, 6u}, {7u, 31u}}) {
      SCOPED_TRACE(std::to_string(width) + " x " + std::to_string(height));
      expect_means(width, height, srgb);
    }
}

}  // namespace
}  // namespace sinew::viewer
