// SPDX-License-Identifier: MIT
#include "importer/geometry_cache/order_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "runtime/geometry_cache/block_motion.h"
#include "tests/support/fixed_random.h"

namespace sinew::test {
namespace {

/// A grid of points one metre apart, numbered by rows or randomly, with two triangles per square.
struct Grid {
  std::vector<glm::vec3> points;
  std::vector<std::uint32_t> triangles;
};

Grid grid(std::uint32_t columns, std::uint32_t rows, bool shuffled) {
  std::vector<std::uint32_t> number(columns * rows);
  std::iota(number.begin(), number.end(), 0u);
  FixedRandom random(3);
  for (std::uint32_t i = columns * rows; shuffled && i-- > 1;) std::swap(number[i], number[random.below(i + 1)]);
  Grid out;
  out.points.resize(number.size());
  const auto at = [&](std::uint32_t x, std::uint32_t y) { return number[y * columns + x]; };
  for (std::uint32_t y = 0; y < rows; ++y)
    for (std::uint32_t x = 0; x < columns; ++x) {
      out.points[at(x, y)] = {x, y, 0.25f * static_cast<float>(x) - static_cast<float>(y)};
      if (x + 1 < columns && y + 1 < rows)
        for (const std::uint32_t v :
             {at(x, y), at(x + 1, y), at(x, y + 1), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)})
          out.triangles.push_back(v);
    }
  return out;
}

PointOrder order_of(const std::vector<glm::vec3>& points, std::span<const std::uint32_t> triangles) {
  const std::vector<std::vector<glm::vec3>> frames(1, points);
  return order_points(frames, triangles);
}

void expect_permutation(const PointOrder& order, std::size_t count) {
  std::vector<std::uint32_t> sorted = order.points;
  std::sort(sorted.begin(), sorted.end());
  ASSERT_EQ(sorted.size(), count);
  for (std::uint32_t i = 0; i < count; ++i) ASSERT_EQ(sorted[i], i);
}

std::set<std::uint32_t> block_of(const PointOrder& order, std::size_t block) {
  const auto begin = order.points.begin() + static_cast<std::ptrdiff_t>(block * kBlockPoints);
  return {begin, begin + static_cast<std::ptrdiff_t>(std::min(kBlockPoints, order.points.size() - block * 64))};
}

TEST(order_points, no_points_have_no_blocks) {
  EXPECT_TRUE(order_points({}, {}).points.empty());
  const std::vector<std::vector<glm::vec3>> frames(2);
  EXPECT_TRUE(order_points(frames, {}).corners.empty());
}

TEST(order_points, up_to_a_block_of_points_without_a_surface_keeps_its_order) {
  for (const std::uint32_t count : {1u, 2u, 63u, 64u}) {
    FixedRandom random(count);
    std::vector<std::vector<glm::vec3>> frames(1);
    for (std::uint32_t p = 0; p < count; ++p) frames[0].push_back(random.vec3());
    const PointOrder order = order_points(frames, {});
    ASSERT_EQ(order.corners.size(), kBlockNumbers);
    for (std::uint32_t p = 0; p < 64; ++p) {
      if (p < count) {
        EXPECT_EQ(order.points[p], p);
      }
      const std::uint8_t before = p > 0 && p < count ? static_cast<std::uint8_t>(p - 1) : kNoCorner;
      EXPECT_EQ(order.corners[3 * p], before) << "each follows the one before, the first and the missing none";
      EXPECT_EQ(order.corners[3 * p + 1], kNoCorner);
      EXPECT_EQ(order.corners[3 * p + 2], kNoCorner);
    }
  }
}

TEST(order_points, blocks_are_parts_of_space_cut_along_the_widest_axis) {
  // 8 by 32 points: the long side is cut three times, into squares of 8 by 8.
  for (const bool turned : {false, true}) {
    Grid all = grid(turned ? 32 : 8, turned ? 8 : 32, true);
    for (glm::vec3& p : all.points) p.z = 0.0f;
    const PointOrder order = order_of(all.points, all.triangles);
    expect_permutation(order, 256);
    for (std::size_t b = 0; b < 4; ++b)
      for (const std::uint32_t p : block_of(order, b))
        EXPECT_EQ(static_cast<std::size_t>(turned ? all.points[p].x : all.points[p].y) / 8, b) << p;
  }
}

TEST(order_points, whole_blocks_are_cut_off_and_the_last_one_takes_the_rest) {
  // Of 5 blocks and 7 points, 2 blocks go to the left; only the last block is not full.
  std::vector<glm::vec3> line;
  FixedRandom random(8);
  for (int i = 0; i < 5 * 64 + 7; ++i) line.push_back({static_cast<float>(random.unit()), 0, 0});
  const PointOrder order = order_of(line, {});
  expect_permutation(order, line.size());
  ASSERT_EQ(order.corners.size(), 6 * kBlockNumbers);
  for (std::size_t b = 0; b + 1 < 6; ++b)
    for (const std::uint32_t p : block_of(order, b))
      for (const std::uint32_t q : block_of(order, b + 1)) ASSERT_LT(line[p].x, line[q].x) << b;
}

TEST(order_points, points_in_one_place_are_cut_by_their_numbers) {
  for (const float apart : {0.0f, 1.0f}) {
    // All in one place, or by turns in two: those of one place stay in order.
    std::vector<glm::vec3> points(256, glm::vec3(0));
    for (std::size_t i = 0; i < 256; i += 2) points[i].y = apart;
    const PointOrder order = order_of(points, {});
    for (std::size_t b = 0; b < 4; ++b)
      for (const std::uint32_t p : block_of(order, b)) {
        const std::size_t expected = apart == 0.0f ? p / 64 : p % 2 == 0 ? 2 + p / 128 : p / 128;
        EXPECT_EQ(expected, b) << p;
      }
  }
}

TEST(order_points, points_that_part_later_are_cut_where_they_are_farthest_apart) {
  // All points coincide except in one of the five inspected frames: the first, the last and those at each quarter.
  for (const std::size_t frame : {0u, 2u, 4u, 6u, 8u}) {
    std::vector<std::vector<glm::vec3>> frames(9, std::vector<glm::vec3>(128, glm::vec3(1)));
    for (std::size_t p = 0; p < 128; ++p) frames[frame][p].z = p % 2 == 0 ? 5.0f : -5.0f;
    const PointOrder order = order_points(frames, {});
    for (const std::uint32_t p : block_of(order, 0)) EXPECT_EQ(p % 2, 1u) << "frame " << frame;
  }
}

TEST(order_points, the_axis_with_the_largest_variance_is_cut_not_the_one_with_the_farthest_point) {
  std::vector<glm::vec3> points(128);
  for (std::size_t p = 0; p < 128; ++p) points[p] = {p % 2 == 0 ? 2.0f : -2.0f, 0, 100.0f};
  points[0].y = 9.0f;  // alone
  const PointOrder order = order_of(points, {});
  for (const std::uint32_t p : block_of(order, 0)) EXPECT_EQ(p % 2, 1u);
}

/// The point that the corners predict.
glm::vec3 predicted(const PointOrder& order, const std::vector<glm::vec3>& points, std::size_t i) {
  glm::vec3 out(0);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::uint8_t corner = order.corners[3 * i + k];
    if (corner == kNoCorner) continue;
    const glm::vec3 p = points[order.points[i / kBlockPoints * kBlockPoints + corner]];
    out += k < 2 ? p : -p;
  }
  return out;
}

TEST(order_points, on_a_surface_all_but_a_few_points_of_a_block_complete_parallelograms) {
  for (const bool shuffled : {false, true}) {
    const Grid all = grid(8, 32, shuffled);
    const PointOrder order = order_of(all.points, all.triangles);
    expect_permutation(order, 256);
    std::size_t others[4] = {};
    for (std::size_t i = 0; i < 256; ++i) {
      const std::size_t in_block = i % kBlockPoints;
      const std::uint8_t* corners = &order.corners[3 * i];
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_TRUE(corners[k] == kNoCorner || corners[k] < in_block);
      }
      EXPECT_EQ(corners[0] == kNoCorner, in_block == 0) << i;
      if (corners[2] != kNoCorner) {
        EXPECT_EQ(predicted(order, all.points, i), all.points[order.points[i]]) << "flat grids are predicted exactly";
        continue;
      }
      ++others[i / kBlockPoints];
      EXPECT_EQ(corners[1], kNoCorner);
      if (in_block == 0) continue;
      const glm::vec3 step = predicted(order, all.points, i) - all.points[order.points[i]];
      EXPECT_LE(std::abs(step.x), 1.0f) << "a neighbour by an edge";
      EXPECT_LE(std::abs(step.y), 1.0f);
    }
    for (const std::size_t count : others) {
      EXPECT_GE(count, 3u);
      EXPECT_LE(count, 4u) << "three points of the first triangle, and one that is reached around it";
    }
  }
}

TEST(order_points, strips_that_do_not_touch_are_walked_one_after_another) {
  // Two strips of triangles in one block: one is finished before the other begins.
  Grid all = grid(2, 10, false);
  const auto count = static_cast<std::uint32_t>(all.points.size());
  for (std::size_t c = 0, corners = all.triangles.size(); c < corners; ++c)
    all.triangles.push_back(all.triangles[c] + count);
  for (std::uint32_t p = 0; p < count; ++p) all.points.push_back(all.points[p] + glm::vec3(50, 0, 0));
  const PointOrder order = order_of(all.points, all.triangles);
  expect_permutation(order, 2 * count);
  for (std::uint32_t i = 0; i < 2 * count; ++i) EXPECT_EQ(order.points[i] / count, i / count) << i;
  EXPECT_EQ(order.corners[3 * count], count - 1) << "the second begins from the point that was walked last";
  for (const std::size_t first : {std::size_t{0}, std::size_t{count}})
    for (std::size_t i = first + 3; i < first + count; ++i) EXPECT_NE(order.corners[3 * i + 2], kNoCorner) << i;
}

TEST(order_points, a_fan_is_walked_from_triangle_to_triangle) {
  // A closed fan around point 0, numbered all over: triangle by triangle both ways around.
  std::vector<glm::vec3> points(9);
  const std::uint32_t ring[] = {5, 1, 7, 3, 8, 2, 6, 4};
  const glm::vec3 places[] = {{1, 0, 0},  {1, 1, 0},   {0, 1, 0},  {-1, 1, 0},
                              {-1, 0, 0}, {-1, -1, 0}, {0, -1, 0}, {1, -1, 0}};
  std::vector<std::uint32_t> triangles;
  for (std::size_t k = 0; k < 8; ++k) {
    points[ring[k]] = places[k];
    for (const std::uint32_t v : {0u, ring[k], ring[(k + 1) % 8]}) triangles.push_back(v);
  }
  const PointOrder order = order_of(points, triangles);
  expect_permutation(order, 9);
  EXPECT_EQ(order.points[0], 0u);
  for (std::size_t i = 3; i < 9; ++i) {
    ASSERT_NE(order.corners[3 * i + 2], kNoCorner);
    EXPECT_TRUE(order.corners[3 * i] == 0 || order.corners[3 * i + 1] == 0) << "across an edge of the hub";
    EXPECT_NE(order.corners[3 * i + 2], 0);
  }
}

}  // namespace
}  // namespace sinew::test
