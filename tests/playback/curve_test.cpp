// SPDX-License-Identifier: MIT
#include "runtime/animation/curve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "runtime/math/axis_angle.h"
#include "runtime/playback/curve_edges.h"
#include "runtime/playback/event_cursor.h"
#include "tests/support/fixed_random.h"

namespace sinew::test {
namespace {

using Keys = std::vector<CurveKey<float>>;
constexpr CurveStep kHold = CurveStep::hold, kLinear = CurveStep::linear, kCubic = CurveStep::cubic;

/// The equations of curve.h, in double.
double truth(const Keys& keys, double time_s) {
  std::size_t k = 0;
  while (k + 1 < keys.size() && double(keys[k + 1].time_s) <= time_s) ++k;
  const CurveKey<float>& a = keys[k];
  if (time_s <= double(a.time_s) || k + 1 == keys.size() || a.step == kHold) return a.value;
  const CurveKey<float>& b = keys[k + 1];
  const double d = double(b.time_s) - double(a.time_s), u = (time_s - double(a.time_s)) / d;
  if (a.step == kLinear) return a.value + u * (double(b.value) - double(a.value));
  const double h00 = 2 * u * u * u - 3 * u * u + 1, h10 = u * u * u - 2 * u * u + u, h01 = 1 - h00,
               h11 = u * u * u - u * u;
  return h00 * double(a.value) + h10 * d * double(a.out_tangent) + h01 * double(b.value) +
         h11 * d * double(b.in_tangent);
}

Keys random_keys(FixedRandom& random) {
  Keys keys;
  float time = static_cast<float>(random.unit()) - 0.3f;
  const std::uint32_t count = 1 + random.below(9);
  for (std::uint32_t k = 0; k < count; ++k) {
    const auto number = [&] { return static_cast<float>(random.unit() * 4 - 2); };
    keys.push_back({time, static_cast<CurveStep>(random.below(3)), number(), number(), number()});
    if (random.below(5) > 0) time += static_cast<float>(random.unit());  // some keys share a time
  }
  return keys;
}

TEST(curve, random_keys_of_every_kind_agree_with_double) {
  FixedRandom random(1);
  for (int i = 0; i < 400; ++i) {
    const Keys keys = random_keys(random);
    ASSERT_EQ(check(Curve<float>(keys)), ErrorCode::ok);
    for (int t = -20; t < 140; ++t) {
      const double time = t * 0.05;
      EXPECT_NEAR(sample(Curve<float>(keys), time), truth(keys, time), 2e-6) << i << ' ' << time;
    }
    for (const CurveKey<float>& key : keys)
      EXPECT_EQ(sample(Curve<float>(keys), double(key.time_s)), float(truth(keys, double(key.time_s)))) << i;
  }
}

TEST(curve, vectors_rotations_and_flags_follow_the_same_keys) {
  const std::vector<CurveKey<glm::vec3>> place = {
      {0, kLinear, {1, 2, 3}}, {2, kHold, {3, 2, 1}}, {4, kHold, {9, 9, 9}}};
  EXPECT_EQ(sample(Curve<glm::vec3>(place), 0.5), glm::vec3(1.5f, 2.0f, 2.5f));
  EXPECT_EQ(sample(Curve<glm::vec3>(place), 3.9), glm::vec3(3, 2, 1));
  const auto about_z = [](float angle) { return quat_from_axis_angle(glm::vec3(0, 0, 1), angle); };
  const std::vector<CurveKey<glm::quat>> aim = {
      {0, kLinear, about_z(0)}, {1, kCubic, -about_z(1)}, {2, kHold, about_z(1)}};
  EXPECT_EQ(check(Curve<glm::quat>(aim)), ErrorCode::ok);
  EXPECT_NEAR(std::abs(glm::dot(sample(Curve<glm::quat>(aim), 0.25), about_z(0.25f))), 1.0f, 1e-6f);
  EXPECT_NEAR(glm::length(sample(Curve<glm::quat>(aim), 1.2)), 1.0f, 1e-6f);
  const std::vector<CurveKey<bool>> flag = {{0, kHold, false}, {1, kHold, true}, {2, kHold, false}};
  EXPECT_FALSE(sample(Curve<bool>(flag), 0.999));
  EXPECT_TRUE(sample(Curve<bool>(flag), 1.0));
  EXPECT_FALSE(sample(Curve<bool>(flag), 7.0));
  EXPECT_EQ(sample(Curve<glm::vec3>(place), std::numeric_limits<double>::quiet_NaN()), glm::vec3(1, 2, 3));
}

TEST(curve, misuse_has_a_code) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  EXPECT_EQ(check(Curve<float>{}), ErrorCode::too_few_keys);
  EXPECT_EQ(check(Curve<float>(Keys{{1}, {0.5f}})), ErrorCode::times_not_increasing);
  EXPECT_EQ(check(Curve<float>(Keys{{nan}})), ErrorCode::not_finite);
  EXPECT_EQ(check(Curve<float>(Keys{{0, kHold, nan}})), ErrorCode::not_finite);
  EXPECT_EQ(check(Curve<float>(Keys{{0, kHold, 0, 0, nan}})), ErrorCode::not_finite);
  EXPECT_EQ(check(Curve<float>(Keys{{0, static_cast<CurveStep>(3)}})), ErrorCode::unsupported);
  EXPECT_EQ(check(Curve<bool>(std::vector<CurveKey<bool>>{{0, kLinear, true}})), ErrorCode::unsupported);
  EXPECT_EQ(check(Curve<glm::quat>(std::vector<CurveKey<glm::quat>>{{0, kHold, glm::quat(2, 0, 0, 0)}})),
            ErrorCode::not_normalised);
}

TEST(curve_edges, a_square_wave_and_a_ramp_cross_where_they_should) {
  const Keys square = {{0, kHold, 0}, {0.2f, kHold, 2}, {0.4f, kHold, 0}, {0.6f, kHold, 2}};
  const CurveEdges jumps = find_edges(Curve<float>(square), 1.0f, 1.0, true);
  EXPECT_EQ(jumps.times_s, (std::vector<double>{0.0, double(0.2f), double(0.4f), double(0.6f)}));
  EXPECT_EQ(jumps.rises, (std::vector<bool>{false, true, false, true}));
  EXPECT_EQ(find_edges(Curve<float>(square), 1.0f, 1.0, false).times_s.size(), 3u);
  EXPECT_TRUE(find_edges(Curve<float>(square), 2.0f, 1.0, true).times_s.empty()) << "equal is not above";
  EXPECT_EQ(find_edges(Curve<float>(square), 1.0f, 0.5, false).times_s.size(), 2u) << "later keys are not played";
  const CurveEdges ramp =
      find_edges(Curve<float>(Keys{{0, kLinear, -1}, {1, kLinear, 3}, {2, kHold, -1}}), 0.0f, 2, true);
  EXPECT_EQ(ramp.times_s, (std::vector<double>{0.25, 1.75}));
  EXPECT_EQ(ramp.rises, (std::vector<bool>{true, false}));
  const CurveEdges flag =
      find_edges(Curve<bool>(std::vector<CurveKey<bool>>{{0, kHold, true}, {0.5f, kHold, false}}), 1.0, true);
  EXPECT_EQ(flag.times_s, (std::vector<double>{0.0, 0.5}));
  EXPECT_EQ(flag.rises, (std::vector<bool>{true, false}));
}

TEST(curve_edges, a_cubic_crosses_three_times_between_two_keys) {
  const Keys keys = {{0, kCubic, -0.5f, 0, 9}, {1, kHold, 0.5f, 9, 0}};
  const CurveEdges edges = find_edges(Curve<float>(keys), 0.0f, 1.0, false);
  ASSERT_EQ(edges.rises, (std::vector<bool>{true, false, true}));
  EXPECT_NEAR(edges.times_s[1], 0.5, 1e-12) << "the middle of a symmetric curve";
  for (const double time : edges.times_s) EXPECT_NEAR(truth(keys, time), 0.0, 1e-12);
}

TEST(curve_edges, a_jump_at_the_very_beginning_is_none_unless_the_clip_loops) {
  const Keys keys = {{0, kHold, 0}, {0, kHold, 5}, {0.5f, kHold, 0}};
  EXPECT_EQ(find_edges(Curve<float>(keys), 1.0f, 1.0, false).times_s, (std::vector<double>{0.5}));
  EXPECT_EQ(find_edges(Curve<float>(keys), 1.0f, 1.0, true).times_s, (std::vector<double>{0.0, 0.5}));
}

TEST(curve_edges, keys_at_one_time_jump_from_where_the_curve_arrives_to_where_it_leaves) {
  const Keys held = {{0, kHold, 0}, {1, kHold, 5}, {1, kHold, 0}, {2, kHold, 5}};
  EXPECT_EQ(find_edges(Curve<float>(held), 1.0f, 3, false).times_s, (std::vector<double>{2.0}));
  const Keys arrives = {{0, kLinear, 0}, {1, kHold, 4}, {1, kHold, 0}};
  const CurveEdges both = find_edges(Curve<float>(arrives), 1.0f, 3, false);
  EXPECT_EQ(both.times_s, (std::vector<double>{0.25, 1.0}));
  EXPECT_EQ(both.rises, (std::vector<bool>{true, false}));
}

/// A cubic may cross three times between two keys. Edges lie where a fine walk along the truth finds them.
TEST(curve_edges, random_curves_cross_where_a_fine_walk_does) {
  FixedRandom random(2);
  std::size_t found = 0, most_in_one = 0;
  for (int i = 0; i < 300; ++i) {
    const Keys keys = random_keys(random);
    const auto threshold = static_cast<float>(random.unit() * 2 - 1);
    const double duration = 3.0;
    const CurveEdges edges = find_edges(Curve<float>(keys), threshold, duration, true);
    EXPECT_TRUE(std::is_sorted(edges.times_s.begin(), edges.times_s.end()));
    // Between edges the sign stays, and it changes at each of them.
    bool above = truth(keys, 0.0) > double(threshold);
    std::size_t next = !edges.times_s.empty() && edges.times_s[0] == 0.0 ? 1 : 0;
    if (next == 1) {
      EXPECT_EQ(edges.rises[0], above);
    }
    for (int step = 1; step <= 30000; ++step) {
      const double time = step * 1e-4;
      for (; next < edges.times_s.size() && edges.times_s[next] <= time - 1e-7; ++next) above = edges.rises[next];
      const bool near_edge = next < edges.times_s.size() && std::abs(edges.times_s[next] - time) < 1e-6;
      const double value = truth(keys, time);
      if (near_edge || std::abs(value - double(threshold)) < 1e-6) continue;
      ASSERT_EQ(value > double(threshold), above) << i << " at " << time;
    }
    found += edges.times_s.size();
    most_in_one = std::max(most_in_one, edges.times_s.size());
  }
  EXPECT_GT(found, 300u);
  EXPECT_GE(most_in_one, 3u);
}

TEST(curve_edges, a_looping_clock_fires_each_edge_once_a_round) {
  const CurveEdges edges =
      find_edges(Curve<float>(Keys{{0, kLinear, -1}, {0.5f, kLinear, 1}, {1, kHold, -1}}), 0.0f, 1.0, true);
  PlaybackClock clock(1.0);
  std::size_t rises = 0, falls = 0;
  for (int frame = 0; frame < 70; ++frame)
    for (EventCursor crossed(clock.advance(0.1), edges.times_s); const auto i = crossed.next();)
      ++(edges.rises[*i] ? rises : falls);
  EXPECT_EQ(rises, 7u);
  EXPECT_EQ(falls, 7u);
}

}  // namespace
}  // namespace sinew::test
