// SPDX-License-Identifier: MIT
// The texts, tangents and built-in limb of `sinew cost`.
#include <gtest/gtest.h>

#include <cmath>

#include "importer/tool/cost/limb.h"
#include "importer/tool/cost/rotation/rotation_tracks.h"
#include "importer/tool/cost/words.h"
#include "runtime/math/quaternion.h"

namespace sinew::test {
namespace {

TEST(cost_words, numbers_have_three_digits) {
  const std::pair<double, const char*> cases[] = {{0.0, "0"},           {1.0, "1.00"},       {4.5678, "4.57"},
                                                  {-0.0123, "-0.0123"}, {56.78, "56.8"},     {100.0, "100"},
                                                  {1234.4, "1234"},     {999999, "999999"},  {1e6, "1.0e+06"},
                                                  {1e-5, "0.0000100"},  {9.9e-6, "9.9e-06"}, {-2e7, "-2.0e+07"}};
  for (const auto& [value, text] : cases) EXPECT_EQ(cost::number(value), text);
}

TEST(cost_words, sentences_begin_with_a_capital_letter) {
  EXPECT_EQ(cost::sentence(""), "");
  EXPECT_EQ(cost::sentence("a to z"), "A to z");
  EXPECT_EQ(cost::sentence("z to a"), "Z to a");
  EXPECT_EQ(cost::sentence("4 to 5"), "4 to 5");
  EXPECT_EQ(cost::sentence("`a`"), "`a`");
  EXPECT_EQ(cost::sentence("{a}"), "{a}");
}

cost::Point point_of(double error, double time_ns, double spread = 0.0) {
  cost::Point point;
  point.error = error;
  point.time_ns = time_ns;
  point.spread = spread;
  return point;
}

TEST(cost_words, errors_have_units_and_angles_a_limit) {
  cost::Group group;
  group.error_unit = "mm";
  EXPECT_EQ(cost::error_of(group, point_of(2.5, 1)), "2.5 mm");
  EXPECT_EQ(cost::error_of(group, point_of(0.01, 1)), "10 um");
  EXPECT_EQ(cost::error_of(group, point_of(0.0, 1)), "nothing");
  group.error_unit = "degrees";
  EXPECT_EQ(cost::error_of(group, point_of(0.5, 1)), "0.500 degrees");
  EXPECT_EQ(cost::error_of(group, point_of(5e-5, 1)), "0.0001 degrees");
  EXPECT_EQ(cost::error_of(group, point_of(1e-4, 1)), "0.000100 degrees");
  EXPECT_EQ(cost::error_of(group, point_of(0.0, 1)), "nothing");
  group.error_unit = "steps";
  EXPECT_EQ(cost::error_of(group, point_of(5e-5, 1)), "0.0000500 steps");
}

TEST(cost_words, times_that_differ_by_noise_are_the_same) {
  cost::Group group;
  group.item = "joint";
  EXPECT_EQ(cost::time_of(group, point_of(0, 4.1)), "4.10 ns a joint");
  EXPECT_EQ(cost::time_beside(group, point_of(0, 95), point_of(0, 100)), "takes as long") << "the limit belongs to it";
  EXPECT_EQ(cost::time_beside(group, point_of(0, 100), point_of(0, 95)), "takes as long");
  EXPECT_EQ(cost::time_beside(group, point_of(0, 94), point_of(0, 100)), "saves 6.00 ns a joint");
  EXPECT_EQ(cost::time_beside(group, point_of(0, 100), point_of(0, 94)), "costs 6.00 ns a joint more");
  EXPECT_EQ(cost::time_beside(group, point_of(0, 94, 0.1), point_of(0, 100)), "takes as long");
  EXPECT_EQ(cost::time_beside(group, point_of(0, 94), point_of(0, 100, 0.1)), "takes as long");
}

TEST(cost_words, the_cheapest_that_is_good_enough_has_to_be_clearly_cheaper_than_the_default) {
  cost::Group group;
  group.points = {point_of(1, 100), point_of(2, 90), point_of(9, 10), point_of(2, 96)};
  group.points[0].name = "first";
  group.points[1].name = "second";
  EXPECT_EQ(&cost::default_of(group), &group.points[0]) << "the first where none is marked";
  group.points[3].is_default = true;
  EXPECT_EQ(&cost::default_of(group), &group.points[3]);
  EXPECT_EQ(cost::find(group, "second"), &group.points[1]);
  EXPECT_EQ(cost::find(group, "third"), nullptr);
  EXPECT_EQ(cost::cheapest_within(group, 2), &group.points[1]);
  EXPECT_EQ(cost::cheapest_within(group, 1), &group.points[0]) << "the default is not good enough";
  EXPECT_EQ(cost::cheapest_within(group, 0.5), nullptr);
  group.points[1].time_ns = 92;
  EXPECT_EQ(cost::cheapest_within(group, 2), &group.points[3]) << "4 % are noise";
  group.points[2].other_aim = true;
  EXPECT_EQ(cost::cheapest_within(group, 10), &group.points[3]);
  group.size_unit = "bytes";
  for (cost::Point& point : group.points) point.size = point.time_ns;
  EXPECT_EQ(cost::cheapest_within(group, 2), &group.points[1]) << "sizes have no noise";
}

// The parabola through (-1, a), (0, b), (2, c) has the slope (2 (b - a) / 1 + 1 (c - b) / 2) / 3 at 0.
TEST(cost_tracks, tangents_of_tracks_without_any_are_those_of_the_parabola_through_the_neighbours) {
  Animation animation;
  animation.bones.resize(1);
  QuatTrack& track = animation.bones[0].rotation;
  const glm::quat a = quat_xyzw(0.0f, 0.0f, 0.0f, 1.0f), b = quat_xyzw(0.6f, 0.0f, 0.0f, 0.8f),
                  c = quat_xyzw(0.0f, 0.6f, 0.0f, 0.8f);
  track = {Interpolation::linear, {1.0f, 2.0f, 4.0f, 4.0f}, {a, -b, c, a}};  // the last two are a jump
  const QuatTrack cubic = cost::rotations_only(animation, Interpolation::cubic_spline).bones.at(0).rotation;
  ASSERT_EQ(cubic.values.size(), 12u);
  const auto expect = [&](std::size_t key, const glm::quat& slope) {
    for (int i = 0; i < 4; ++i) {
      EXPECT_NEAR(cubic.values[3 * key][i], slope[i], 1e-6f) << key;
      EXPECT_EQ(cubic.values[3 * key + 2][i], cubic.values[3 * key][i]);
    }
  };
  expect(0, b - a);
  expect(1, ((b - a) * 2.0f + (c - b) * 0.5f) / 3.0f);
  expect(2, (c - b) / 2.0f);
  expect(3, quat_xyzw(0.0f, 0.0f, 0.0f, 0.0f));
  EXPECT_EQ(cubic.values[4], b) << "in the hemisphere of the key before";
}

TEST(cost_limb, weights_go_evenly_from_one_joint_to_the_other) {
  const cost::Limb limb;
  const VertexInfluences& influences = limb.primitive.influences;
  std::size_t seen = 0;
  for (const InfluenceGroup& group : influences.groups) {
    for (std::uint32_t v = 0; v < group.vertex_count; ++v, ++seen) {
      const double along = std::clamp((limb.primitive.positions[group.first_vertex + v].y - 1.2) / 1.6, 0.0, 1.0);
      double of_second = 0.0, sum = 0.0;
      for (std::uint32_t i = 0; i < group.influence_count; ++i) {
        const std::size_t at = group.first_influence + v * group.influence_count + i;
        EXPECT_GT(influences.weights[at], 0.0f);
        sum += influences.weights[at];
        if (influences.joints[at] == 1) of_second += influences.weights[at];
      }
      EXPECT_NEAR(sum, 1.0, 1e-6);
      EXPECT_NEAR(of_second, along, 1e-6);
    }
  }
  EXPECT_EQ(seen, limb.primitive.positions.size());
}

TEST(cost_limb, the_volume_of_a_tetrahedron_is_a_sixth) {
  const glm::vec3 positions[] = {{1, 1, 1}, {2, 1, 1}, {1, 2, 1}, {1, 1, 2}};
  const std::uint32_t indices[] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
  EXPECT_NEAR(cost::volume_of(positions, indices), 1.0 / 6.0, 1e-12);
}

}  // namespace
}  // namespace sinew::test
