// SPDX-License-Identifier: MIT
#include "viewer/upload/mip_chain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace sinew::viewer {
namespace {

double decoded(int code) {
  const double c = code / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

int encoded(double linear) {
  const double c = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
  return static_cast<int>(std::lround(c * 255.0));
}

std::vector<std::uint8_t> grey_ramp(std::uint32_t width, std::uint32_t height) {
  std::vector<std::uint8_t> rgba;
  for (std::uint32_t i = 0; i < width * height; ++i)
    for (std::uint32_t c = 0; c < 4; ++c) rgba.push_back(static_cast<std::uint8_t>((i * 37 + c * 91) % 256));
  return rgba;
}

TEST(mip_chain, averages_colours_in_linear_light) {
  const std::vector<std::uint8_t> black_white = {0, 0, 0, 0, 255, 255, 255, 255, 0, 0, 0, 0, 255, 255, 255, 255};
  const auto levels = mip_chain(black_white, 2, 2, true);
  ASSERT_EQ(levels.size(), 2u);
  EXPECT_EQ(levels[1].rgba, (std::vector<std::uint8_t>{188, 188, 188, 128}));  // not 128: half the light looks brighter
}

TEST(mip_chain, averages_data_as_it_is) {
  const std::vector<std::uint8_t> texels = {10, 0, 255, 1, 20, 0, 255, 2, 30, 0, 255, 3, 43, 0, 255, 4};
  EXPECT_EQ(mip_chain(texels, 2, 2, false)[1].rgba, (std::vector<std::uint8_t>{26, 0, 255, 3}));
}

TEST(mip_chain, agrees_with_the_formula_on_every_texel_of_odd_sizes) {
  const std::uint32_t width = 13, height = 7;
  const auto levels = mip_chain(grey_ramp(width, height), width, height, true);
  for (std::size_t l = 1; l < levels.size(); ++l) {
    const MipLevel &from = levels[l - 1], &to = levels[l];
    EXPECT_EQ(to.width, std::max(from.width / 2, 1u));
    EXPECT_EQ(to.height, std::max(from.height / 2, 1u));
    for (std::uint32_t y = 0; y < to.height; ++y)
      for (std::uint32_t x = 0; x < to.width; ++x) {
        double sum = 0.0;
        for (const std::uint32_t row : {2 * y, 2 * y + 1})
          for (const std::uint32_t column : {2 * x, 2 * x + 1})
            sum += decoded(
                from.rgba[4 * (std::min(row, from.height - 1) * from.width + std::min(column, from.width - 1))]);
        EXPECT_EQ(to.rgba[4 * (y * to.width + x)], encoded(sum / 4.0)) << l << ' ' << x << ' ' << y;
      }
  }
}

TEST(mip_chain, keeps_a_plain_colour_at_every_level) {
  for (int code = 0; code < 256; ++code) {
    const std::vector<std::uint8_t> texels(4 * 4 * 4, static_cast<std::uint8_t>(code));
    EXPECT_EQ(mip_chain(texels, 4, 4, true).back().rgba[0], code);
  }
}

TEST(mip_chain, ends_at_one_texel) {
  EXPECT_EQ(mip_count(1, 1), 1u);
  EXPECT_EQ(mip_count(256, 3), 9u);
  const auto levels = mip_chain(grey_ramp(1, 9), 1, 9, false);
  EXPECT_EQ(levels.size(), 4u);
  EXPECT_EQ(levels.back().width * levels.back().height, 1u);
}

}  // namespace
}  // namespace sinew::viewer
