// SPDX-License-Identifier: MIT
#include "runtime/deform/vertex_tiles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "tests/support/shared_joints.h"
#include "tests/support/skinned_vertices.h"

namespace sinew {
namespace {

constexpr std::uint32_t kCounts[] = {1, 2, 3, 4, 5, 9};

test::SkinnedVertices surface(std::uint32_t group_size, std::uint32_t sets) {
  test::FixedRandom random(group_size * 100 + sets);
  auto s = test::random_skinned_vertices(random, kCounts, group_size, 24, false);
  test::share_joints(random, s, sets);
  return s;
}

/// Calls `body(run, lane of the run, vertex)` for the lanes that hold vertices of their own.
template <class Body>
void for_each_lane(const VertexTiles& tiles, const Body& body) {
  for (const TileRun& run : tiles.runs)
    for (std::uint32_t lane = 0; lane < run.lane_count; ++lane)
      body(run, lane, tiles.vertices[std::size_t{run.first_tile} * VertexTiles::kLanes + lane]);
}

/// Weight of a lane by joint, the implied one included; 0 entries are left out.
std::map<std::uint16_t, double> weights_of(const VertexTiles& tiles, const TileRun& run, std::uint32_t lane) {
  std::map<std::uint16_t, double> weights;
  const std::size_t tile = lane / VertexTiles::kLanes, in_tile = lane % VertexTiles::kLanes;
  double left = 1;
  for (std::uint32_t i = 0; i + 1 < run.joint_count; ++i) {
    const double w = tiles.weights[run.first_weight + tile * run.weights_per_tile() + i].lane[in_tile];
    left -= w;
    if (w != 0) weights[tiles.joints[run.first_joint + i]] = w;
  }
  if (std::abs(left) > 1e-6) weights[tiles.joints[run.first_joint + run.joint_count - 1]] = left;
  return weights;
}

class VertexTilesOf : public testing::TestWithParam<std::uint32_t> {};

TEST_P(VertexTilesOf, each_vertex_has_one_lane_and_spare_lanes_repeat_the_last) {
  const auto s = surface(GetParam(), 3);
  const VertexTiles tiles = tile_vertices(s.influences, s.in());
  ASSERT_EQ(tiles.vertex_count, s.positions.size());
  std::vector<int> lanes(s.positions.size());
  for_each_lane(tiles, [&](const TileRun&, std::uint32_t, std::uint32_t vertex) { ++lanes[vertex]; });
  EXPECT_EQ(std::count(lanes.begin(), lanes.end(), 1), static_cast<std::ptrdiff_t>(lanes.size()));
  for (const TileRun& run : tiles.runs) {
    const std::size_t first = std::size_t{run.first_tile} * VertexTiles::kLanes;
    for (std::size_t lane = run.lane_count; lane % VertexTiles::kLanes != 0; ++lane)
      EXPECT_EQ(tiles.vertices[first + lane], tiles.vertices[first + run.lane_count - 1]);
  }
}

TEST_P(VertexTilesOf, planes_hold_the_attributes_and_the_weights_as_given) {
  const auto s = surface(GetParam(), 3);
  const VertexTiles tiles = tile_vertices(s.influences, s.in());
  for_each_lane(tiles, [&](const TileRun& run, std::uint32_t lane, std::uint32_t v) {
    const std::size_t of_run = lane / VertexTiles::kLanes, tile = run.first_tile + of_run,
                      in_tile = lane % VertexTiles::kLanes;
    for (int c = 0; c < 4; ++c) {
      const auto plane = static_cast<std::size_t>(c);
      EXPECT_EQ(tiles.tangents[tile * 4 + plane].lane[in_tile], s.tangents[v][c]);
      if (c == 3) break;
      EXPECT_EQ(tiles.positions[tile * 3 + plane].lane[in_tile], s.positions[v][c]);
      EXPECT_EQ(tiles.normals[tile * 3 + plane].lane[in_tile], s.normals[v][c]);
    }
    const auto weights = weights_of(tiles, run, lane);
    ASSERT_EQ(weights.size(), s.joints_of(v).size()) << v;
    for (std::size_t i = 0; i < weights.size(); ++i)
      EXPECT_NEAR(weights.at(s.joints_of(v)[i]), double{s.weights_of(v)[i]}, 3e-7) << v;
  });
}

TEST_P(VertexTilesOf, lanes_at_the_front_of_runs_are_vertices_in_a_row) {
  const auto s = surface(GetParam(), 2);
  const VertexTiles tiles = tile_vertices(s.influences, s.in());
  for (const TileRun& run : tiles.runs) {
    const std::size_t first = std::size_t{run.first_tile} * VertexTiles::kLanes;
    const auto in_a_row = [&](std::uint32_t end, std::uint32_t size) {
      EXPECT_LE(end, run.lane_count);
      EXPECT_EQ(end % size, 0u);
      for (std::size_t lane = 0; lane < end; ++lane)
        EXPECT_EQ(tiles.vertices[first + lane], tiles.vertices[first + lane / size * size] + lane % size);
    };
    in_a_row(run.in_fours, 4);
    in_a_row(run.in_eights, 8);
    in_a_row(run.in_sixteens, 16);
    for (std::size_t four = first / 4; four < (first + run.lane_count) / 4; ++four)
      if (tiles.fours[four] != VertexTiles::kNotInARow) {
        for (std::size_t i = 0; i < 4; ++i) EXPECT_EQ(tiles.vertices[four * 4 + i], tiles.fours[four] + i);
      } else {
        EXPECT_GE(four * 4 - first, run.in_fours);
      }
  }
}

INSTANTIATE_TEST_SUITE_P(group_sizes, VertexTilesOf, testing::Values(1u, 3u, 7u, 8u, 16u, 17u, 40u, 200u));

/// Vertices with equal shares of their joints.
VertexInfluences even_shares(std::span<const std::vector<std::uint16_t>> joints_of) {
  VertexInfluences out;
  for (std::uint32_t v = 0; v < joints_of.size(); ++v) {
    const auto count = static_cast<std::uint32_t>(joints_of[v].size());
    if (out.groups.empty() || out.groups.back().influence_count != count)
      out.groups.push_back({v, 0, count, static_cast<std::uint32_t>(out.joints.size())});
    ++out.groups.back().vertex_count;
    for (const std::uint16_t joint : joints_of[v]) {
      out.joints.push_back(joint);
      out.weights.push_back(1.0f / static_cast<float>(count));
    }
  }
  return out;
}

VertexTiles tiles_of(std::span<const std::vector<std::uint16_t>> joints_of) {
  const std::vector<glm::vec3> positions(joints_of.size());
  return tile_vertices(even_shares(joints_of), {.positions = positions, .normals = {}, .tangents = {}});
}

TEST(vertex_tiles, no_vertices_are_no_tiles) {
  const VertexTiles tiles = tiles_of({});
  EXPECT_TRUE(tiles.empty());
  EXPECT_EQ(tiles.tile_count(), 0u);
  EXPECT_EQ(tiles.relative_cost(), 1.0);
}

TEST(vertex_tiles, the_order_of_joints_makes_no_difference) {
  std::vector<std::vector<std::uint16_t>> joints;
  for (int v = 0; v < 16; ++v)
    joints.push_back(v % 3 == 0 ? std::vector<std::uint16_t>{2, 5} : std::vector<std::uint16_t>{5, 2});
  const VertexTiles tiles = tiles_of(joints);
  ASSERT_EQ(tiles.runs.size(), 1u);
  EXPECT_EQ(tiles.runs[0].in_sixteens, 16u);
  EXPECT_EQ(tiles.joint_count, 6u);
  EXPECT_NEAR(tiles.relative_cost(), 1.5, 1e-12) << "two vectors and the start of a run";
}

TEST(vertex_tiles, vertices_left_over_take_free_lanes_of_a_larger_set) {
  std::vector<std::vector<std::uint16_t>> joints(3, {1});
  joints.resize(8, {1, 4});
  const VertexTiles tiles = tiles_of(joints);
  ASSERT_EQ(tiles.runs.size(), 1u);
  EXPECT_EQ(tiles.runs[0].lane_count, 8u);
  EXPECT_EQ(tiles.runs[0].joint_count, 2u);
}

TEST(vertex_tiles, vertices_left_over_stay_where_no_larger_set_has_room_for_all) {
  std::vector<std::vector<std::uint16_t>> joints(4, {1});
  joints.resize(9, {1, 4});
  const VertexTiles tiles = tiles_of(joints);
  ASSERT_EQ(tiles.runs.size(), 2u);
  EXPECT_EQ(tiles.runs[0].lane_count, 4u);
  EXPECT_NEAR(tiles.relative_cost(), (2 + 2 * 1.8) * 8 / 9, 1e-12) << "two starts, two vectors of which no one is full";
}

TEST(vertex_tiles, vertices_left_over_are_not_in_a_row_any_more) {
  std::vector<std::vector<std::uint16_t>> joints(13, {1});
  joints.resize(16, {1, 4});
  const VertexTiles tiles = tiles_of(joints);
  ASSERT_EQ(tiles.runs.size(), 2u);
  EXPECT_EQ(tiles.runs[0].lane_count, 8u);
  EXPECT_EQ(tiles.runs[0].in_fours, 8u);
}

TEST(vertex_tiles, vertices_left_over_of_several_sets_share_a_run) {
  std::vector<std::vector<std::uint16_t>> joints(2, {1});
  joints.resize(5, {1, 4});
  joints.resize(8, {1, 4, 5});
  const VertexTiles tiles = tiles_of(joints);
  ASSERT_EQ(tiles.runs.size(), 1u);
  EXPECT_EQ(tiles.runs[0].lane_count, 8u);
}

TEST(vertex_tiles, long_stretches_end_where_their_set_ends) {
  std::vector<std::vector<std::uint16_t>> joints(5, {3});
  joints.resize(70, {1});
  joints.resize(80, {2});
  const VertexTiles tiles = tiles_of(joints);
  ASSERT_EQ(tiles.runs.size(), 3u);
  EXPECT_EQ(tiles.runs[0].lane_count, 5u);
  EXPECT_EQ(tiles.runs[1].lane_count, 65u);
  EXPECT_EQ(tiles.runs[1].in_sixteens, 48u) << "from vertex 16 to 64";
  EXPECT_EQ(tiles.vertices[std::size_t{tiles.runs[1].first_tile} * VertexTiles::kLanes], 16u);
}

/// The matrix of the last joint of a run is the base of all of its blends, whose rounding grows with it.
TEST(vertex_tiles, vertices_left_over_follow_the_last_joint_of_their_new_run) {
  std::vector<std::vector<std::uint16_t>> joints(3, {7});
  joints.resize(8, {1, 7});
  EXPECT_EQ(tiles_of(joints).runs.size(), 2u);
}

TEST(vertex_tiles, weights_are_divided_by_their_sum) {
  const VertexInfluences influences{{{0, 1, 2, 0}}, {0, 1}, {0.6f, 0.6f}};
  const std::vector<glm::vec3> positions(1);
  const VertexTiles tiles = tile_vertices(influences, {.positions = positions, .normals = {}, .tangents = {}});
  EXPECT_EQ(tiles.weights[0].lane[0], 0.5f);
}

}  // namespace
}  // namespace sinew
