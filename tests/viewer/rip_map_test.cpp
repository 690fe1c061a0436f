// SPDX-License-Identifier: MIT
#include "viewer/upload/rip_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "tests/reference/shade.h"
#include "tests/reference/texture.h"
#include "tests/support/fixed_random.h"

namespace sinew::viewer {
namespace {

std::vector<std::uint8_t> noise(std::uint32_t width, std::uint32_t height) {
  test::FixedRandom random(11);
  std::vector<std::uint8_t> rgba(std::size_t{4} * width * height);
  for (std::uint8_t& code : rgba) code = static_cast<std::uint8_t>(random.in(0.0, 256.0));
  return rgba;
}

/// Mean of the texels that one texel of level (i, j) stands for.
glm::dvec4 mean(const std::vector<std::uint8_t>& rgba, std::uint32_t width, std::uint32_t i, std::uint32_t j,
                std::uint32_t x, std::uint32_t y, const TexelUse& use) {
  std::vector<glm::dvec4> texels;
  for (std::uint32_t row = y << j; row < (y + 1) << j; ++row)
    for (std::uint32_t column = x << i; column < (x + 1) << i; ++column) {
      glm::dvec4& texel = texels.emplace_back();
      for (int c = 0; c < 4; ++c) {
        texel[c] = rgba[4 * (std::size_t{row} * width + column) + static_cast<std::size_t>(c)] / 255.0;
        if (use.srgb && c < 3) texel[c] = reference::srgb_decoded(texel[c]);
      }
    }
  if (use.alpha_covers) return reference::covered_mean(texels);
  return std::accumulate(texels.begin(), texels.end(), glm::dvec4(0.0)) / static_cast<double>(texels.size());
}

void expect_means(std::uint32_t width, std::uint32_t height, const TexelUse& use) {
  const auto rgba = noise(width, height);
  const MipLevel map = rip_map(rgba, width, height, use);
  ASSERT_EQ(map.width, 2 * width);
  ASSERT_EQ(map.height, 2 * height);
  ASSERT_EQ(map.rgba.size(), 4 * rgba.size());
  for (std::uint32_t j = 0; height >> j > 0; ++j)
    for (std::uint32_t i = 0; width >> i > 0; ++i)
      for (std::uint32_t y = 0; y < height >> j; ++y)
        for (std::uint32_t x = 0; x < width >> i; ++x) {
          const glm::dvec4 expected = mean(rgba, width, i, j, x, y, use);
          const std::size_t column = 2 * width - 2 * (width >> i) + x, row = 2 * height - 2 * (height >> j) + y;
          for (int c = 0; c < 4; ++c) {
            const double value = use.srgb && c < 3 ? reference::srgb_encoded(expected[c]) : expected[c];
            ASSERT_NEAR(map.rgba[4 * (row * map.width + column) + static_cast<std::size_t>(c)], 255.0 * value, 0.505)
                << "level " << i << ' ' << j << ", texel " << x << ' ' << y << ", channel " << c;
          }
        }
}

TEST(rip_map, every_texel_of_every_level_is_the_mean_of_what_it_stands_for_rounded_once) {
  for (const TexelUse& use : {TexelUse{}, {.srgb = true}, {.srgb = true, .alpha_covers = true}})
    for (const auto& [width, height] : {std::pair(16u, 16u), {32u, 4u}, {1u, 8u}, {1u, 1u}, {13u, 6u}, {7u, 31u}}) {
      SCOPED_TRACE(std::to_string(width) + " x " + std::to_string(height));
      expect_means(width, height, use);
    }
}

TEST(rip_map, alpha_tests_keep_the_same_share_of_every_level) {
  const std::uint32_t size = 32;
  const MipLevel map = rip_map(noise(size, size), size, size, {true, true, 200});
  const auto kept = [&](std::uint32_t i, std::uint32_t j) {
    std::vector<std::uint8_t> level;
    for (std::uint32_t y = 0; y < size >> j; ++y) {
      const std::size_t column = 2 * size - 2 * (size >> i), row = 2 * size - 2 * (size >> j) + y;
      const auto from = map.rgba.begin() + static_cast<std::ptrdiff_t>(4 * (row * map.width + column));
      level.insert(level.end(), from, from + 4 * (size >> i));
    }
    return reference::kept_share(level, int(size >> i), int(size >> j), 199.5);
  };
  for (std::uint32_t j = 0; j < 4; ++j)
    for (std::uint32_t i = 0; i < 4; ++i) EXPECT_NEAR(kept(i, j), kept(0, 0), 0.03) << "level " << i << ' ' << j;
}

}  // namespace
}  // namespace sinew::viewer
