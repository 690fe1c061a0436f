// SPDX-License-Identifier: MIT
// Prefiltered environments and the split sum, compared with plain double-precision sums.
#include "viewer/light/environment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "tests/reference/ambient.h"
#include "tests/reference/sheen.h"
#include "tests/support/fixed_random.h"
#include "viewer/light/sheen_albedo.h"
#include "viewer/light/split_sum.h"

namespace sinew::viewer {
namespace {

double greatest(const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); }

glm::vec3 random_direction(test::FixedRandom& random) {
  for (;;) {
    const glm::vec3 d(random.in(-1.0, 1.0), random.in(-1.0, 1.0), random.in(-1.0, 1.0));
    if (const float length = glm::length(d); length > 0.1f && length < 1.0f) return d / length;
  }
}

/// A sky that is asymmetric on all axes, with a bright spot.
glm::vec3 some_sky(const glm::vec3& d) {
  const float spot = std::exp(-30.0f * (1.0f - glm::dot(d, glm::normalize(glm::vec3(0.5f, 0.6f, -0.7f)))));
  return glm::vec3(0.3f + 0.2f * d.x, 0.4f - 0.3f * d.y * d.z, 0.5f + 0.1f * d.z) + glm::vec3(6.0f, 5.0f, 2.0f) * spot;
}

/// Integrates `share(direction)` times radiance over a map.
template <class Share>
glm::dvec3 gathered(const CubeMap& cube, const Share& share) {
  glm::dvec3 sum(0.0);
  double weights = 0.0;
  std::size_t at = 0;
  for (std::uint32_t face = 0; face < kCubeFaces; ++face)
    for (std::uint32_t y = 0; y < cube.size; ++y)
      for (std::uint32_t x = 0; x < cube.size; ++x) {
        const double weight = share(glm::dvec3(texel_direction(face, x, y, cube.size))) *
                              static_cast<double>(texel_solid_angle(x, y, cube.size));
        sum += glm::dvec3(cube.texels[at++]) * weight;
        weights += weight;
      }
  return sum / weights;
}

glm::dvec3 diffuse_at(const Environment& e, const glm::dvec3& n) {
  const double basis[] = {
      1.0, n.y, n.z, n.x, n.x * n.y, n.y * n.z, 3.0 * n.z * n.z - 1.0, n.x * n.z, n.x * n.x - n.y * n.y};
  glm::dvec3 sum(0.0);
  for (std::size_t k = 0; k < 9; ++k) sum += glm::dvec3(e.diffuse[k]) * basis[k];
  return sum;
}

TEST(cube_map, faces_point_where_Vulkan_looks_texels_cover_the_sphere_and_are_found_again) {
  const glm::vec3 middles[] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  for (std::uint32_t face = 0; face < kCubeFaces; ++face) EXPECT_EQ(face_direction(face, 0, 0), middles[face]);
  EXPECT_EQ(face_direction(0, 1, 0), glm::vec3(1, 0, -1));  // the right edge of +x touches -z, its upper edge +y
  EXPECT_EQ(face_direction(0, 0, -1), glm::vec3(1, 1, 0));
  EXPECT_EQ(face_direction(2, 0, 1), glm::vec3(0, 1, 1));  // the lower edge of +y touches +z
  const CubeMap directions = cube_of(8, [](const glm::vec3& d) { return d; });
  double angle = 0.0;
  std::size_t at = 0;
  for (std::uint32_t face = 0; face < kCubeFaces; ++face)
    for (std::uint32_t y = 0; y < 8; ++y)
      for (std::uint32_t x = 0; x < 8; ++x) {
        const glm::vec3 d = texel_direction(face, x, y, 8);
        EXPECT_LT(glm::length(sample(directions, d * 3.0f) - d), 1e-5f);
        EXPECT_EQ(directions.texels[at++], d);
        angle += static_cast<double>(texel_solid_angle(x, y, 8));
      }
  EXPECT_NEAR(angle, 4.0 * std::numbers::pi, 0.01 * 4.0 * std::numbers::pi);
}

TEST(cube_map, between_texels_it_is_linear_and_half_the_size_has_their_mean) {
  test::FixedRandom random(3);
  const CubeMap linear = cube_of(32, [](const glm::vec3& d) { return d; });
  const CubeMap half = halved(linear);
  ASSERT_EQ(half.size, 16u);
  for (int i = 0; i < 200; ++i) {
    const glm::vec3 d = random_direction(random);
    EXPECT_LT(glm::length(sample(linear, d) - d), 0.05f);  // constant on the outer half texel of a face
    EXPECT_LT(glm::length(sample(half, d) - d), 0.1f);
  }
  EXPECT_EQ(half.texels[16 * 16 + 3], 0.25f * (linear.texels[32 * 32 + 6] + linear.texels[32 * 32 + 7] +
                                               linear.texels[32 * 32 + 38] + linear.texels[32 * 32 + 39]));
}

TEST(environment, diffuse_light_is_the_cosine_weighted_mean_of_the_sky) {
  const auto made = make_environment(cube_of(64, some_sky));
  const CubeMap sky = cube_of(64, some_sky);
  test::FixedRandom random(5);
  for (int i = 0; i < 40; ++i) {
    const glm::dvec3 n(random_direction(random));
    const glm::dvec3 truth = gathered(sky, [&](const glm::dvec3& d) { return std::max(0.0, glm::dot(d, n)); });
    // Order 3 leaves out 1 % of the energy of any light, and more of a spot.
    EXPECT_LT(greatest(glm::abs(diffuse_at(*made, n) - truth)), 0.05) << n.x << " " << n.y << " " << n.z;
  }
}

TEST(environment, reflected_light_is_weighted_as_GGX_reflects_it) {
  const CubeMap sky = cube_of(64, some_sky);
  const auto made = make_environment(sky);
  ASSERT_EQ(made->reflected.size(), kEnvironmentLevels);
  EXPECT_EQ(made->reflected[0].texels, sky.texels);
  test::FixedRandom random(9);
  for (std::uint32_t level = 1; level < kEnvironmentLevels; ++level) {
    const CubeMap& filtered = made->reflected[level];
    ASSERT_EQ(filtered.size, 64u >> level);
    const double alpha = std::pow(static_cast<double>(level) / (kEnvironmentLevels - 1), 2.0), a2 = alpha * alpha;
    for (int i = 0; i < 12; ++i) {
      const auto face = static_cast<std::uint32_t>(random.in(0.0, 6.0)),
                 x = static_cast<std::uint32_t>(random.in(0.0, filtered.size)),
                 y = static_cast<std::uint32_t>(random.in(0.0, filtered.size));
      const glm::dvec3 n(texel_direction(face, x, y, filtered.size));
      const glm::dvec3 truth = gathered(sky, [&](const glm::dvec3& l) {
        const double n_l = glm::dot(n, l), cos2 = 0.5 * (1.0 + n_l), d = cos2 * (a2 - 1.0) + 1.0;
        return n_l <= 0.0 ? 0.0 : n_l * a2 / (d * d);
      });
      const glm::dvec3 got(filtered.texels[(std::size_t{face} * filtered.size + y) * filtered.size + x]);
      EXPECT_LT(greatest(glm::abs(got - truth) / (truth + 0.1)), 0.12) << "level " << level;
    }
  }
}

TEST(environment, gradient_in_closed_form_is_what_the_filter_makes_of_it) {
  const Gradient light{.sky = {0.9f, 0.5f, 0.2f}, .ground = {0.1f, 0.2f, 0.4f}};
  const auto exact = gradient_environment(light);
  const auto made = make_environment(cube_of(exact->reflected[0].size, [&](const glm::vec3& d) {
    return glm::mix(light.ground, light.sky, 0.5f + 0.5f * d.y);
  }));
  for (std::size_t k = 0; k < 9; ++k) EXPECT_LT(glm::length(exact->diffuse[k] - made->diffuse[k]), 2e-3f) << k;
  for (std::uint32_t level = 0; level < kEnvironmentLevels; ++level)
    for (std::size_t i = 0; i < exact->reflected[level].texels.size(); i += 7)
      EXPECT_LT(glm::length(exact->reflected[level].texels[i] - made->reflected[level].texels[i]), 0.02f)
          << level << " " << i;
  for (const double roughness : {0.05, 0.3, 0.7, 1.0})
    EXPECT_NEAR(mean_reflected_cosine(roughness), reference::reflected_cosine(roughness), 1e-3) << roughness;
}

TEST(environment, white_from_everywhere_stays_white) {
  const auto made = make_environment(cube_of(32, [](const glm::vec3&) { return glm::vec3(1.0f); }));
  for (const CubeMap& level : made->reflected)
    for (const glm::vec3& texel : level.texels) EXPECT_LT(glm::length(texel - 1.0f), 1e-5f);
  EXPECT_LT(glm::length(made->diffuse[0] - 1.0f), 1e-5f);
  for (std::size_t k = 1; k < 9; ++k) EXPECT_LT(glm::length(made->diffuse[k]), 1e-2f) << k;
}

TEST(split_sum, is_that_of_the_integral_over_all_half_vectors) {
  for (const float roughness : {0.045f, 0.1f, 0.3f, 0.6f, 0.8f, 1.0f})
    for (const float n_v : {0.01f, 0.05f, 0.2f, 0.5f, 0.8f, 1.0f}) {
      const glm::dvec2 truth = reference::reflected_once(static_cast<double>(n_v), static_cast<double>(roughness));
      const glm::dvec2 got(split_sum(n_v, roughness));
      EXPECT_LT(glm::length(got - truth), 0.004) << n_v << " " << roughness;
    }
}

TEST(sheen_albedo, is_that_of_the_integral_over_the_half_sphere) {
  for (const float roughness : {kLeastSheenRoughness, 0.2f, 0.5f, 0.8f, 1.0f})
    for (const float n_v : {0.001f, 0.05f, 0.3f, 0.7f, 1.0f}) {
      const double wanted = reference::sheen_albedo(static_cast<double>(n_v), static_cast<double>(roughness));
      EXPECT_NEAR(static_cast<double>(sheen_albedo(n_v, roughness)), wanted, 0.005 * std::max(1.0, wanted))
          << roughness << " " << n_v;
    }
  EXPECT_EQ(sheen_albedo(0.3f, 0.0f), sheen_albedo(0.3f, kLeastSheenRoughness));
}

TEST(split_sum, axes_are_roughness_and_sqrt_cosine) {
  const auto& table = split_sum_table();
  ASSERT_EQ(table.size(), std::size_t{kSplitSumSize} * kSplitSumSize);
  constexpr float last = kSplitSumSize - 1;
  for (const std::uint32_t row : {5u, 31u, 63u})
    for (const std::uint32_t column : {0u, 20u, 63u}) {
      const float root = static_cast<float>(column) / last;
      const glm::vec3& at = table[row * kSplitSumSize + column];
      EXPECT_EQ(glm::vec2(at), split_sum(root * root, static_cast<float>(row) / last));
      EXPECT_EQ(at.z, sheen_albedo(root * root, static_cast<float>(row) / last));
    }
}

TEST(split_sum, conserves_energy) {
  for (const glm::vec3& sums : split_sum_table()) {
    EXPECT_GE(std::min(sums.x, sums.y), 0.0f);
    EXPECT_LE(sums.x + sums.y, 1.0f + 1e-4f);
  }
}

}  // namespace
}  // namespace sinew::viewer
