// SPDX-License-Identifier: MIT
#include "runtime/deform/influence_streams.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "runtime/deform/vertex_checks.h"
#include "tests/support/near.h"
#include "tests/support/simd_targets.h"
#include "tests/support/skinning_ways.h"

namespace sinew {
namespace {

using test::Way;

/// Normalised weights that still sum to 1: the heaviest takes what rounding leaves.
template <class Number>
std::vector<Number> normalised_weights(const test::SkinnedVertices& s) {
  constexpr double kMost = std::numeric_limits<Number>::max();
  std::vector<Number> out(s.influences.weights.size());
  for (const InfluenceGroup& g : s.influences.groups)
    for (std::uint32_t v = 0; v < g.vertex_count; ++v) {
      const std::size_t first = g.first_influence + std::size_t{v} * g.influence_count;
      double rest = kMost;
      for (std::size_t i = first + 1; i < first + g.influence_count; ++i) {
        out[i] = static_cast<Number>(std::lround(static_cast<double>(s.influences.weights[i]) * kMost));
        rest -= out[i];
      }
      out[first] = static_cast<Number>(rest);
    }
  return out;
}

template <class Number>
std::vector<float> floats_of(const std::vector<Number>& weights) {
  std::vector<float> out;
  for (const Number w : weights)
    out.push_back(static_cast<float>(w / static_cast<double>(std::numeric_limits<Number>::max())));
  return out;
}

struct Skinned {
  std::vector<glm::vec3> positions, normals;
  friend bool operator==(const Skinned&, const Skinned&) = default;
};

Skinned skin(Way way, test::SkinnedVertices& s, const InfluenceStreams& influences) {
  test::skin(way, s, s.normals, influences);
  return {s.out_positions, s.out_normals};
}

class SkinningInputs : public testing::TestWithParam<Way> {};

TEST_P(SkinningInputs, small_joints_and_normalised_weights_have_the_bits_of_the_numbers_that_they_stand_for) {
  test::FixedRandom random(81);
  const std::uint32_t counts[] = {1, 2, 3, 4, 5, 8, 12, InfluenceStreams::kMostWidened};
  for (const std::uint32_t group_size : {1u, 7u, 17u, 40u, 300u}) {
    auto s = test::random_skinned_vertices(random, counts, group_size, 64, true);
    const std::vector<std::uint8_t> joints8(s.influences.joints.begin(), s.influences.joints.end()),
        weights8 = normalised_weights<std::uint8_t>(s);
    const std::vector<std::uint16_t> weights16 = normalised_weights<std::uint16_t>(s);
    const std::span<const std::uint16_t> joints16 = s.influences.joints;
    const std::span<const InfluenceGroup> groups = s.influences.groups;
    const std::vector<float> from8 = floats_of(weights8), from16 = floats_of(weights16), plain = s.influences.weights;
    for (const std::int64_t target : test::simd_targets()) {
      const test::OnlyTarget only(target);
      const auto expect = [&](const InfluenceStreams& small, const std::vector<float>& same) {
        EXPECT_EQ(check_influences(small, s.positions.size(), 64), ErrorCode::ok);
        EXPECT_TRUE(skin(GetParam(), s, small) == skin(GetParam(), s, {groups, joints16, std::span(same)}))
            << test::simd_name(target) << ' ' << group_size;
      };
      expect({groups, std::span(joints8), std::span(plain)}, plain);
      expect({groups, std::span(joints8), std::span(weights8)}, from8);
      expect({groups, std::span(joints8), std::span(weights16)}, from16);
      expect({groups, joints16, std::span(weights8)}, from8);
      expect({groups, joints16, std::span(weights16)}, from16);
    }
  }
}

/// Vertices at (1, 0, 0) of a joint that rests, and of one that takes them to the origin: x is the first weight.
template <class Number>
void expect_quotients() {
  constexpr std::uint32_t kSteps = std::uint32_t{1} << std::numeric_limits<Number>::digits;
  const InfluenceGroup groups[] = {{0, kSteps, 2, 0}};
  std::vector<std::uint16_t> joints;
  std::vector<Number> weights;
  for (std::uint32_t c = 0; c < kSteps; ++c) {
    joints.insert(joints.end(), {0, 1});
    weights.insert(weights.end(), {static_cast<Number>(c), Number{0}});
  }
  const std::vector<JointMatrix> palette{JointMatrix{},
                                         joint_matrix_from(affine_from(Mat3<float>(0.0f), glm::vec3(0)))};
  const std::vector<glm::vec3> positions(kSteps, {1, 0, 0});
  std::vector<glm::vec3> out(kSteps);
  EXPECT_EQ(run(SkinLinearJob{{groups, std::span<const std::uint16_t>(joints), std::span<const Number>(weights)},
                              palette,
                              {positions, {}, {}},
                              {out, {}, {}},
                              NormalRule::linear}),
            ErrorCode::ok);
  std::uint32_t wrong = 0;
  for (std::uint32_t c = 0; c < kSteps; ++c)
    wrong += out[c].x != static_cast<float>(c) / static_cast<float>(kSteps - 1);
  EXPECT_EQ(wrong, 0u) << kSteps;
}

TEST(influence_streams, every_small_weight_is_its_quotient_rounded_once) {
  for (const std::int64_t target : test::simd_targets()) {
    const test::OnlyTarget only(target);
    SCOPED_TRACE(test::simd_name(target));
    expect_quotients<std::uint8_t>();
    expect_quotients<std::uint16_t>();
  }
}

/// What rounding weights costs, as a part of the spread of where single joints would put a vertex. Only linear blending
/// is linear in its weights.
TEST(influence_streams, linear_rounded_weights_move_a_vertex_by_half_a_step_for_each_influence_at_the_most) {
  test::FixedRandom random(82);
  const std::uint32_t counts[] = {4, 8};
  auto s = test::random_skinned_vertices(random, counts, 200, 24, false);
  const Skinned exact = skin(Way::linear, s, &s.influences);
  const auto worst_of = [&](const auto& weights) {
    const Skinned found = skin(
        Way::linear, s, {s.influences.groups, std::span<const std::uint16_t>(s.influences.joints), std::span(weights)});
    double worst = 0.0;
    for (std::size_t v = 0; v < s.positions.size(); ++v) {
      double spread = 0.0;
      const auto place = [&](std::uint16_t joint) {
        return Vec3<double>(transform_point(affine_from(s.palette[joint]), s.positions[v]));
      };
      for (const auto joint : s.joints_of(v)) spread += glm::length(place(joint) - place(s.joints_of(v)[0]));
      worst =
          std::max(worst, glm::length(Vec3<double>(found.positions[v]) - Vec3<double>(exact.positions[v])) / spread);
    }
    return worst;
  };
  const auto weights8 = normalised_weights<std::uint8_t>(s);
  const auto weights16 = normalised_weights<std::uint16_t>(s);
  EXPECT_LE(worst_of(weights8), 0.5 / 255 + 1e-6);
  EXPECT_LE(worst_of(weights16), 0.5 / 65535 + 1e-6);
  EXPECT_GT(worst_of(weights8), 0.05 / 255);
}

TEST(influence_streams, are_rejected_where_a_vertex_has_more_influences_than_are_widened) {
  constexpr std::uint32_t kMany = InfluenceStreams::kMostWidened + 1;
  const InfluenceGroup groups[] = {{0, 1, kMany, 0}};
  const std::vector<std::uint8_t> joints(kMany, 0), weights(kMany, 0);
  const std::vector<std::uint16_t> wide_joints(kMany, 0);
  const std::vector<float> wide_weights(kMany, 0.0f);
  EXPECT_EQ(check_influences({groups, std::span(joints), std::span(weights)}, 1, 1), ErrorCode::unsupported);
  EXPECT_EQ(check_influences({groups, std::span(wide_joints), std::span(weights)}, 1, 1), ErrorCode::unsupported);
  EXPECT_EQ(check_influences({groups, std::span(wide_joints), std::span(wide_weights)}, 1, 1), ErrorCode::ok);
}

TEST(influence_streams, small_joints_out_of_range_are_found) {
  const InfluenceGroup groups[] = {{0, 2, 1, 0}};
  const std::uint8_t joints[] = {3, 4}, weights[] = {255, 255};
  EXPECT_EQ(check_influences({groups, std::span(joints), std::span(weights)}, 2, 5), ErrorCode::ok);
  EXPECT_EQ(check_influences({groups, std::span(joints), std::span(weights)}, 2, 4), ErrorCode::index_out_of_range);
  EXPECT_EQ(check_influences({groups, std::span(joints), std::span(weights).first(1)}, 2, 5), ErrorCode::size_mismatch);
}

TEST(influence_streams, groups_follow_each_other_vertex_by_vertex_and_end_with_the_last) {
  const std::uint8_t joints[] = {0, 0, 0}, weights[] = {255, 255, 255};
  const auto code = [&](const std::array<InfluenceGroup, 2>& groups) {
    return check_influences({groups, std::span(joints), std::span(weights)}, 3, 1);
  };
  EXPECT_EQ(code({{{0, 1, 1, 0}, {1, 2, 1, 1}}}), ErrorCode::ok);
  EXPECT_EQ(code({{{0, 1, 1, 0}, {0, 2, 1, 1}}}), ErrorCode::size_mismatch);
  EXPECT_EQ(code({{{1, 1, 1, 0}, {2, 2, 1, 1}}}), ErrorCode::size_mismatch);
  EXPECT_EQ(code({{{0, 1, 1, 0}, {1, 1, 1, 1}}}), ErrorCode::size_mismatch);
  EXPECT_EQ(code({{{0, 1, 1, 0}, {1, 2, 1, 2}}}), ErrorCode::size_mismatch);
  EXPECT_EQ(code({{{0, 1, 0, 0}, {1, 2, 1, 1}}}), ErrorCode::size_mismatch);
}

INSTANTIATE_TEST_SUITE_P(ways, SkinningInputs, testing::ValuesIn(test::kWays));

}  // namespace
}  // namespace sinew
