// SPDX-License-Identifier: MIT
#include "importer/topology/centers_of_rotation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <numbers>
#include <random>
#include <span>

#include "tests/support/skinning_ways.h"

namespace sinew {
namespace {

/// A tube along +Y over `joints` joints. Each vertex has four influences with smooth random weights.
Primitive tube(std::uint32_t columns, std::uint32_t rows, std::uint16_t joints, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> unit(0.05f, 1.0f);
  Primitive out;
  for (std::uint32_t r = 0; r <= rows; ++r)
    for (std::uint32_t c = 0; c < columns; ++c) {
      const float angle = 2.0f * std::numbers::pi_v<float> * static_cast<float>(c) / static_cast<float>(columns);
      out.positions.emplace_back(std::sin(angle), static_cast<float>(r) * 0.25f, std::cos(angle));
      float weights[4], sum = 0.0f;
      for (float& w : weights) sum += w = unit(random);
      for (std::uint16_t i = 0; i < 4; ++i) {
        out.influences.joints.push_back(static_cast<std::uint16_t>((r + i) % joints));
        out.influences.weights.push_back(weights[i] / sum);
      }
    }
  for (std::uint32_t r = 0; r < rows; ++r)
    for (std::uint32_t c = 0; c < columns; ++c) {
      const std::uint32_t a = r * columns + c, b = r * columns + (c + 1) % columns;
      out.indices.insert(out.indices.end(), {a, b, b + columns, a, b + columns, a + columns});
    }
  out.influences.groups = {{0, static_cast<std::uint32_t>(out.positions.size()), 4, 0}};
  return out;
}

/// A tube with two joints whose weights change only along its length: all vertices of a ring have the same weights.
Primitive two_bone_tube(std::uint32_t columns, std::uint32_t rows) {
  Primitive out = tube(columns, rows, 8, 1);
  out.influences = {};
  for (std::uint32_t r = 0; r <= rows; ++r)
    for (std::uint32_t c = 0; c < columns; ++c) {
      const float w = (static_cast<float>(r) + 0.5f) / (static_cast<float>(rows) + 1.0f);
      out.influences.joints.insert(out.influences.joints.end(), {0, 1});
      out.influences.weights.insert(out.influences.weights.end(), {1.0f - w, w});
    }
  out.influences.groups = {{0, static_cast<std::uint32_t>(out.positions.size()), 2, 0}};
  return out;
}

/// Centers by the equation in centers_of_rotation.h, summed directly over all triangles and all pairs of joints.
std::vector<glm::dvec3> by_definition(const Primitive& p, std::size_t joint_count, double sigma) {
  const std::size_t count = p.vertex_count();
  std::vector<std::vector<double>> w(count, std::vector<double>(joint_count, 0.0));
  const std::uint32_t n = p.influences.groups[0].influence_count;
  for (std::size_t v = 0; v < count; ++v)
    for (std::size_t i = 0; i < n; ++i)
      w[v][p.influences.joints[v * n + i]] += static_cast<double>(p.influences.weights[v * n + i]);
  std::vector<glm::dvec3> centers(count);
  for (std::size_t v = 0; v < count; ++v) {
    glm::dvec3 sum(0.0);
    double total = 0.0;
    for (std::size_t t = 0; t + 2 < p.indices.size(); t += 3) {
      const auto a = p.indices[t], b = p.indices[t + 1], c = p.indices[t + 2];
      const glm::dvec3 x(p.positions[a]), y(p.positions[b]), z(p.positions[c]);
      double s = 0.0;
      for (std::size_t j = 0; j < joint_count; ++j)
        for (std::size_t k = 0; k < joint_count; ++k) {
          if (j == k) continue;
          const double tj = (w[a][j] + w[b][j] + w[c][j]) / 3.0, tk = (w[a][k] + w[b][k] + w[c][k]) / 3.0;
          const double d = w[v][j] * tk - w[v][k] * tj;
          s += w[v][j] * w[v][k] * tj * tk * std::exp(-d * d / (sigma * sigma));
        }
      s *= 0.5 * glm::length(glm::cross(y - x, z - x));
      sum += s * (x + y + z) / 3.0;
      total += s;
    }
    centers[v] = sum / total;
  }
  return centers;
}

/// Volume of the tube, closed by a fan of triangles at each end.
double volume_of(std::span<const std::uint32_t> triangles, std::span<const glm::vec3> positions,
                 std::uint32_t columns) {
  const auto signed_volume = [](const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
    return glm::dot(a, glm::cross(b, c)) / 6.0;
  };
  double sum = 0.0;
  for (std::size_t i = 0; i < triangles.size(); i += 3)
    sum += signed_volume(positions[triangles[i]], positions[triangles[i + 1]], positions[triangles[i + 2]]);
  const std::size_t top = positions.size() - columns;
  for (std::uint32_t c = 1; c + 1 < columns; ++c) {
    sum += signed_volume(positions[0], positions[c + 1], positions[c]);
    sum += signed_volume(positions[top], positions[top + c], positions[top + c + 1]);
  }
  return sum;
}

TEST(centers_of_rotation,
     N20_about_them_a_bent_tube_keeps_more_volume_than_linearly_and_swells_less_than_with_dual_quaternions) {
  constexpr std::uint32_t kColumns = 24;
  const Primitive p = two_bone_tube(kColumns, 40);
  const auto centers = centers_of_rotation(p);
  const double rest = volume_of(p.indices, p.positions, kColumns);
  ASSERT_NEAR(rest, std::numbers::pi * 10.0, 0.5);
  test::SkinnedVertices s;
  s.positions = p.positions;
  s.influences = p.influences;
  s.out_positions.resize(p.vertex_count());
  for (const double degrees : {45.0, 90.0, 120.0}) {
    const double half = degrees * std::numbers::pi / 360.0;
    const Affine bend = affine_from_transform(
        Transform{{0, 0, 0}, quat_cast<float>(quat_xyzw(0.0, 0.0, std::sin(half), std::cos(half))), glm::vec3(1)});
    const Affine up = affine_from(Mat3<float>(1), {0, 5, 0}), down = affine_from(Mat3<float>(1), {0, -5, 0});
    s.palette = {JointMatrix{}, joint_matrix_from(up * bend * down)};  // at the middle of the tube
    const auto share = [&](test::Way way) {
      skin(way, s, centers);
      return volume_of(p.indices, s.out_positions, kColumns) / rest;
    };
    const double linear = share(test::Way::linear), dual = share(test::Way::dual_quaternion),
                 center = share(test::Way::center_of_rotation);
    EXPECT_LT(linear, center) << degrees;
    EXPECT_LT(std::abs(center - 1.0), std::abs(linear - 1.0)) << degrees;
    EXPECT_LE(center, dual) << degrees;
  }
}

struct TemporaryFolder {
  std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("sinew-centers-" + std::to_string(std::random_device{}()));
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
};

TEST(centers_of_rotation, N21_agree_with_the_definition_over_all_triangles) {
  const Primitive p = tube(7, 9, 6, 42);
  const auto truth = by_definition(p, 6, 0.1);
  const auto centers = centers_of_rotation(p);
  ASSERT_EQ(centers.size(), truth.size());
  for (std::size_t v = 0; v < truth.size(); ++v) EXPECT_LT(glm::length(glm::dvec3(centers[v]) - truth[v]), 1e-6) << v;
}

TEST(centers_of_rotation, N21_triangles_that_one_joint_moves_alike_and_another_not_are_told_apart) {
  // The first joint has half the weight of every vertex. The shares of the other two change from ring to ring.
  Primitive p = tube(6, 12, 3, 2);
  p.influences = {};
  for (std::size_t v = 0; v < p.vertex_count(); ++v) {
    const auto ring = static_cast<float>(v / 6);
    const float second = ring <= 6.0f ? 0.25f + 0.03f * ring : 0.5f - 0.02f * ring;
    p.influences.joints.insert(p.influences.joints.end(), {0, 1, 2});
    p.influences.weights.insert(p.influences.weights.end(), {0.5f, second, 0.5f - second});
  }
  p.influences.groups = {{0, static_cast<std::uint32_t>(p.vertex_count()), 3, 0}};
  const auto truth = by_definition(p, 3, 0.1);
  const auto centers = centers_of_rotation(p);
  for (std::size_t v = 0; v < truth.size(); ++v) EXPECT_LT(glm::length(glm::dvec3(centers[v]) - truth[v]), 1e-6) << v;
}

TEST(centers_of_rotation, N21_of_a_tube_lie_on_its_axis) {
  for (const auto& center : centers_of_rotation(two_bone_tube(16, 20))) {
    EXPECT_NEAR(center.x, 0.0f, 1e-5f);
    EXPECT_NEAR(center.z, 0.0f, 1e-5f);
  }
}

TEST(centers_of_rotation, N21_a_single_influence_keeps_its_own_position) {
  Primitive p = two_bone_tube(8, 4);
  const auto count = static_cast<std::uint32_t>(p.vertex_count());
  p.influences = {{{0, count, 1, 0}}, std::vector<std::uint16_t>(count, 0), std::vector<float>(count, 1.0f)};
  EXPECT_TRUE(centers_of_rotation(p) == p.positions);
}

TEST(centers_of_rotation, degenerate_triangles_leave_the_vertices_where_they_are) {
  Primitive p = two_bone_tube(8, 4);
  for (auto& position : p.positions) position = glm::vec3(1.0f, 2.0f, 3.0f);
  EXPECT_TRUE(centers_of_rotation(p) == p.positions);
}

TEST(centers_of_rotation, progress_rises_to_one) {
  double last = 0.0;
  CentersOptions options;
  options.progress = [&](double done) {
    EXPECT_GE(done, last);
    last = done;
  };
  centers_of_rotation(tube(16, 40, 8, 3), options);
  EXPECT_EQ(last, 1.0);
}

TEST(centers_of_rotation, second_run_reads_the_cache_and_gives_the_same_bits) {
  const TemporaryFolder folder;
  const Primitive p = tube(7, 9, 6, 5);
  CentersOptions options;
  options.cache_folder = folder.path;
  const auto first = centers_of_rotation(p, options);
  bool computed = false;
  options.progress = [&](double) { computed = true; };
  EXPECT_TRUE(centers_of_rotation(p, options) == first);
  EXPECT_FALSE(computed);
  options.sigma = 0.2;
  EXPECT_FALSE(centers_of_rotation(p, options) == first);
  EXPECT_TRUE(computed);
}

TEST(centers_of_rotation, a_damaged_cache_file_is_replaced) {
  const TemporaryFolder folder;
  const Primitive p = tube(7, 9, 6, 5);
  CentersOptions options;
  options.cache_folder = folder.path;
  const auto first = centers_of_rotation(p, options);
  for (const auto& entry : std::filesystem::directory_iterator(folder.path)) {
    std::fstream file(entry.path(), std::ios::in | std::ios::out | std::ios::binary);
    file.seekp(100);
    file.put('\x7f');
  }
  EXPECT_TRUE(centers_of_rotation(p, options) == first);
}

}  // namespace
}  // namespace sinew
