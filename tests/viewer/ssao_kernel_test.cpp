// SPDX-License-Identifier: MIT
#include "viewer/passes/ssao_kernel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace sinew::viewer {
namespace {

TEST(ssao_kernel, has_eight_cube_corners_and_six_face_centres_of_length_a_quarter_to_one) {
  const SsaoKernel kernel = make_ssao_kernel();
  int corners = 0, faces = 0;
  for (const glm::vec3& offset : kernel.offsets) {
    const float length = glm::length(offset);
    EXPECT_GE(length, 0.25f - 1e-6f);
    EXPECT_LE(length, 1.0f + 1e-6f);
    const glm::vec3 a = glm::abs(offset) / length;
    if (std::abs(a.x - a.y) < 1e-5f && std::abs(a.y - a.z) < 1e-5f) ++corners;
    if (std::max({a.x, a.y, a.z}) > 1.0f - 1e-6f) ++faces;
  }
  EXPECT_EQ(corners, 8);
  EXPECT_EQ(faces, 6);
}

TEST(ssao_kernel, directions_differ_and_lengths_vary) {
  const SsaoKernel kernel = make_ssao_kernel();
  for (std::size_t i = 0; i < 14; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_LT(glm::dot(glm::normalize(kernel.offsets[i]), glm::normalize(kernel.offsets[j])), 0.9f);
      EXPECT_NE(glm::length(kernel.offsets[i]), glm::length(kernel.offsets[j]));
    }
}

TEST(ssao_kernel, spreads_any_number_of_lines_evenly) {
  for (const std::uint32_t samples : {2u, 4u, 8u, 16u, 32u, 64u}) {
    const SsaoKernel kernel = make_ssao_kernel(samples);
    ASSERT_EQ(kernel.offsets.size(), samples);
    for (std::size_t i = 0; i < samples; i += 2) {
      const glm::vec3 line = glm::normalize(kernel.offsets[i]);
      EXPECT_LT(glm::dot(line, glm::normalize(kernel.offsets[i + 1])), -0.999f) << "both ends of a line";
      for (std::size_t j = 0; j < i; j += 2) {
        // samples / 2 caps of height 4 / samples have the area of the sphere. Lines must be at least half the angular
        // radius of such a cap apart.
        const float cap = 1.0f - 4.0f / static_cast<float>(samples);
        EXPECT_LT(std::abs(glm::dot(line, glm::normalize(kernel.offsets[j]))),
                  std::cos(0.5f * std::acos(std::max(cap, 0.0f))))
            << samples;
      }
    }
  }
}

TEST(ssao_kernel, N34_is_the_same_in_every_run_and_its_noise_is_unit_vectors) {
  const SsaoKernel a = make_ssao_kernel(), b = make_ssao_kernel();
  EXPECT_EQ(a.offsets, b.offsets);
  EXPECT_EQ(a.noise, b.noise);
  for (const glm::vec3& mirror : a.noise) EXPECT_NEAR(glm::length(mirror), 1.0f, 1e-6f);
}

}  // namespace
}  // namespace sinew::viewer
