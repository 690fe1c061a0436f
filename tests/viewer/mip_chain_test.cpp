// SPDX-License-Identifier: MIT
#include "viewer/upload/mip_chain.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/reference/texture.h"
#include "tests/support/fixed_random.h"
#include "viewer/upload/alpha_coverage.h"

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
  const auto levels = mip_chain(black_white, 2, 2, {.srgb = true});
  ASSERT_EQ(levels.size(), 2u);
  EXPECT_EQ(levels[1].rgba, (std::vector<std::uint8_t>{188, 188, 188, 128}));  // not 128: half the light looks brighter
}

TEST(mip_chain, averages_data_as_it_is) {
  const std::vector<std::uint8_t> texels = {10, 0, 255, 1, 20, 0, 255, 2, 30, 0, 255, 3, 43, 0, 255, 4};
  EXPECT_EQ(mip_chain(texels, 2, 2, {})[1].rgba, (std::vector<std::uint8_t>{26, 0, 255, 3}));
}

TEST(mip_chain, agrees_with_the_formula_on_every_texel_of_odd_sizes) {
  const std::uint32_t width = 13, height = 7;
  const auto levels = mip_chain(grey_ramp(width, height), width, height, {.srgb = true});
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
    EXPECT_EQ(mip_chain(texels, 4, 4, {.srgb = true}).back().rgba[0], code);
  }
}

constexpr TexelUse kCovering{.srgb = true, .alpha_covers = true};

std::vector<std::uint8_t> noise(std::uint32_t texels) {
  test::FixedRandom random(5);
  std::vector<std::uint8_t> rgba(std::size_t{4} * texels);
  for (std::uint8_t& code : rgba) code = static_cast<std::uint8_t>(random.in(0.0, 256.0));
  for (std::size_t i = 3; i < rgba.size(); i += 4)
    if (rgba[i] < 90) rgba[i] = 0;  // a third of it is transparent, some blocks all
  return rgba;
}

TEST(mip_chain, colours_count_by_alpha_where_it_covers) {
  const std::uint32_t width = 16, height = 8;
  const auto levels = mip_chain(noise(width * height), width, height, kCovering);
  for (std::size_t l = 1; l < levels.size(); ++l) {
    const MipLevel &from = levels[l - 1], &to = levels[l];
    for (std::uint32_t y = 0; y < to.height; ++y)
      for (std::uint32_t x = 0; x < to.width; ++x) {
        std::vector<glm::dvec4> block;
        for (const std::uint32_t row : {2 * y, std::min(2 * y + 1, from.height - 1)})
          for (const std::uint32_t column : {2 * x, std::min(2 * x + 1, from.width - 1)}) {
            const std::uint8_t* t = &from.rgba[4 * (row * from.width + column)];
            block.emplace_back(decoded(t[0]), decoded(t[1]), decoded(t[2]), t[3] / 255.0);
          }
        const glm::dvec4 mean = reference::covered_mean(block);
        const std::uint8_t* out = &to.rgba[4 * (y * to.width + x)];
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(out[c], encoded(mean[c]), 1) << l << ' ' << x << ' ' << y;
        EXPECT_NEAR(out[3], 255.0 * mean.a, 0.501);
      }
  }
}

TEST(mip_chain, what_transparent_texels_hold_shows_at_no_level_unless_all_are_transparent) {
  std::vector<std::uint8_t> rgba;
  for (int i = 0; i < 64; ++i) {
    const bool leaf = i % 3 == 0;
    for (const int code : {leaf ? 40 : 255, leaf ? 120 : 0, leaf ? 30 : 255, leaf ? 255 : 0})
      rgba.push_back(static_cast<std::uint8_t>(code));
  }
  for (const MipLevel& level : mip_chain(rgba, 8, 8, kCovering))
    for (std::size_t i = 0; i < level.rgba.size(); i += 4)
      if (level.rgba[i + 3] > 0) {
        EXPECT_NEAR(level.rgba[i], 40, 1);
        EXPECT_NEAR(level.rgba[i + 1], 120, 1);
      }
  const std::vector<std::uint8_t> nothing = {10, 20, 30, 0, 10, 20, 30, 0, 10, 20, 30, 0, 10, 20, 30, 0};
  EXPECT_EQ(mip_chain(nothing, 2, 2, kCovering)[1].rgba, (std::vector<std::uint8_t>{10, 20, 30, 0}));
}

TEST(mip_chain, images_that_cover_all_keep_their_bytes) {
  std::vector<std::uint8_t> rgba = noise(64);
  for (std::size_t i = 3; i < rgba.size(); i += 4) rgba[i] = 255;
  const auto plain = mip_chain(rgba, 8, 8, {.srgb = true}), covering = mip_chain(rgba, 8, 8, kCovering),
             cut = mip_chain(rgba, 8, 8, {true, true, 128});
  for (std::size_t l = 0; l < plain.size(); ++l) {
    EXPECT_EQ(plain[l].rgba, covering[l].rgba);
    EXPECT_EQ(plain[l].rgba, cut[l].rgba);
  }
}

double kept(const MipLevel& level, int cutoff) {
  return reference::kept_share(level.rgba, static_cast<int>(level.width), static_cast<int>(level.height),
                               cutoff - 0.5);  // alpha between two codes is rounded
}

TEST(mip_chain, alpha_tests_keep_the_same_share_of_every_level) {
  test::FixedRandom random(8);
  for (const bool cut_out : {false, true}) {  // alpha of 0 and 255 alone, or any
    std::vector<std::uint8_t> rgba = noise(64 * 64);
    for (std::size_t i = 3; cut_out && i < rgba.size(); i += 4) rgba[i] = random.in(0.0, 1.0) < 0.25 ? 255 : 0;
    const std::uint8_t cutoff = cut_out ? 128 : 60;
    const auto levels = mip_chain(rgba, 64, 64, {true, true, cutoff}), plain = mip_chain(rgba, 64, 64, kCovering);
    EXPECT_EQ(levels[0].rgba, rgba) << "the image itself stays";
    for (std::size_t l = 1; l < 5; ++l) {  // to 4 x 4
      EXPECT_NEAR(kept(levels[l], cutoff), kept(levels[0], cutoff), 0.05)
          << "cutoff " << int{cutoff} << ", level " << l;
      MipLevel kept_alone = plain[l];
      keep_coverage(levels[0], cutoff, kept_alone);
      EXPECT_EQ(levels[l].rgba, kept_alone.rgba) << "that of the image, not of the level before";
      for (std::size_t i = 0; i < levels[l].rgba.size(); ++i)
        EXPECT_TRUE(i % 4 == 3 || levels[l].rgba[i] == plain[l].rgba[i]) << "colours are as without a test";
    }
    EXPECT_GT(std::abs(kept(plain[3], cutoff) - kept(plain[0], cutoff)), 0.15) << "which means alone do not";
  }
}

TEST(mip_chain, ends_at_one_texel) {
  EXPECT_EQ(mip_count(1, 1), 1u);
  EXPECT_EQ(mip_count(256, 3), 9u);
  const auto levels = mip_chain(grey_ramp(1, 9), 1, 9, {});
  EXPECT_EQ(levels.size(), 4u);
  EXPECT_EQ(levels.back().width * levels.back().height, 1u);
}

}  // namespace
}  // namespace sinew::viewer
