// SPDX-License-Identifier: MIT
// Fades with curves of their own.
#include "runtime/graph/fade_curve.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

#include "runtime/graph/fade_share.h"
#include "runtime/graph/read_graph_state.h"
#include "tests/graph/graph_player.h"

namespace sinew {
namespace {

using test::GraphPlayer;

/// The share by the algorithm of de Casteljau: between two keys, h apart, the cubic has the Bezier values p0,
/// p0 + h s0 / 3, p1 - h s1 / 3, p1.
double truth_share(const std::vector<GraphFadeKey>& keys, double u) {
  std::size_t k = 0;
  while (k + 2 < keys.size() && u > static_cast<double>(keys[k + 1].at)) ++k;
  const double h = static_cast<double>(keys[k + 1].at) - static_cast<double>(keys[k].at);
  const double t = (u - static_cast<double>(keys[k].at)) / h;
  std::vector<double> p = {static_cast<double>(keys[k].share),
                           static_cast<double>(keys[k].share) + h * static_cast<double>(keys[k].slope) / 3.0,
                           static_cast<double>(keys[k + 1].share) - h * static_cast<double>(keys[k + 1].slope) / 3.0,
                           static_cast<double>(keys[k + 1].share)};
  for (std::size_t level = 3; level > 0; --level)
    for (std::size_t i = 0; i < level; ++i) p[i] += t * (p[i + 1] - p[i]);
  return p[0];
}

std::vector<GraphFadeKey> random_keys(std::mt19937& random, bool rising) {
  std::uniform_real_distribution<float> unit(0.0f, 1.0f);
  std::vector<GraphFadeKey> points(random() % 6);
  std::vector<float> at(points.size()), share(points.size());
  for (std::size_t i = 0; i < at.size(); ++i)
    at[i] = (static_cast<float>(i) + 1.0f + 0.5f * unit(random)) / (static_cast<float>(at.size()) + 1.5f);
  for (float& value : share) value = unit(random);
  if (rising) std::sort(share.begin(), share.end());
  for (std::size_t i = 0; i < points.size(); ++i) points[i] = {at[i], share[i]};
  const float first = points.empty() ? 1.0f : points[0].share / points[0].at;
  const float last = points.empty() ? 1.0f : (1.0f - points.back().share) / (1.0f - points.back().at);
  return fade_curve_keys(2.999f * unit(random) * first, 2.999f * unit(random) * last, points);
}

TEST(fade_curve, is_the_cubic_of_its_keys_and_stays_within_their_shares) {
  std::mt19937 random(7);
  for (int curve = 0; curve < 300; ++curve) {
    const bool rising = curve % 2 == 0;
    const std::vector<GraphFadeKey> keys = random_keys(random, rising);
    double before = 0.0;
    for (int i = 0; i <= 500; ++i) {
      const double u = i / 500.0, share = curve_share(keys, u);
      ASSERT_NEAR(share, truth_share(keys, u), 1e-12) << curve << " at " << u;
      ASSERT_GE(share, rising ? before - 1e-12 : 0.0) << curve << " at " << u;
      before = share;
    }
    for (const GraphFadeKey& key : keys)
      EXPECT_NEAR(curve_share(keys, static_cast<double>(key.at)), static_cast<double>(key.share), 1e-12);
    for (std::size_t k = 1; k + 1 < keys.size(); ++k) {  // no kink
      const double at = static_cast<double>(keys[k].at), h = 1e-7;
      EXPECT_NEAR((curve_share(keys, at + h) - curve_share(keys, at)) / h,
                  (curve_share(keys, at) - curve_share(keys, at - h)) / h, 1e-2);
    }
  }
}

TEST(fade_curve, two_slopes_make_the_curves_that_have_names) {
  const auto linear = fade_curve_keys(1, 1, {}), smooth = fade_curve_keys(0, 0, {}), out = fade_curve_keys(2, 0, {});
  for (int i = -1; i <= 11; ++i) {
    const double u = i / 10.0;
    EXPECT_NEAR(curve_share(linear, u), fade_share(GraphFade::linear, u), 1e-15);
    EXPECT_NEAR(curve_share(smooth, u), fade_share(GraphFade::smooth, u), 1e-15);
    EXPECT_NEAR(curve_share(out, u), fade_share(GraphFade::ease_out, u), 1e-15);
  }
}

/// A walk of 1 m/s fades within a second into a run of 4 m/s, by a curve through (0.5, 0.8).
struct Curved {
  RootTrack walk = way(1.0f), run = way(4.0f);
  std::vector<double> steps = {0.25, 0.75};
  std::vector<GraphFadeKey> keys = fade_curve_keys(0.5f, 0.25f, std::vector{GraphFadeKey{0.5f, 0.8f}});
  GraphBuilder b;
  GraphIndex machine = b.machine("m");

  Curved() {
    const GraphIndex slow = b.state(machine, "walk", b.clip("walk")), fast = b.state(machine, "run", b.clip("run"));
    const GraphIndex curve = b.curve(0.5f, 0.25f, std::vector{GraphFadeKey{0.5f, 0.8f}});
    b.transition(machine, slow, {.duration_s = 1.0f, .to = fast, .curve = curve}, {when_in_state_for(1.0f)});
  }
  static RootTrack way(float metres) {
    BoneAnimation root;
    root.translation = {Interpolation::linear, {0.0f, 1.0f}, {{0, 0, 0}, {0, 0, metres}}};
    return RootTrack::make(root, {}, {}, 1e-6);
  }
  GraphPlayer player() { return GraphPlayer(b, machine, {{0, 1.0, steps, &walk}, {1, 1.0, steps, &run}}); }
};

TEST(fade_curve, pose_root_motion_and_events_follow_it) {
  Curved curved;
  GraphPlayer player = curved.player();
  player.advance(1.0);
  for (int frame = 1; frame < 60; ++frame) {
    const GraphStep step = player.advance(1.0 / 60.0);
    const double share = truth_share(curved.keys, frame / 60.0);
    ASSERT_EQ(player.ops().size(), 3u);
    EXPECT_NEAR(static_cast<double>(player.ops()[1].weight), share, 1e-6) << frame;
    // Root motion has constant velocity in cells of 1/60 s.
    const double of_cell = truth_share(curved.keys, (frame - 0.5) / 60.0);
    EXPECT_NEAR(translation_of(step.root_motion).z * 60.0, 1.0 + 3.0 * of_cell, 1e-5) << frame;
  }
  std::vector<float> weights;
  for (const GraphEvent& event : player.log())
    if (event.kind == GraphEventKind::clip && event.clip == 1) weights.push_back(event.weight);
  ASSERT_EQ(weights.size(), 2u);
  EXPECT_NEAR(static_cast<double>(weights[0]), truth_share(curved.keys, 0.25), 1e-6);
  EXPECT_NEAR(static_cast<double>(weights[1]), truth_share(curved.keys, 0.75), 1e-6);
}

TEST(fade_curve, each_rule_names_what_breaks_it) {
  struct Case {
    const char* text;
    std::function<void(GraphTables&)> change;
  };
  const char* const overshoots =
      "curve 0: a slope of it is not between 0 and three times the way to the next key, so it would overshoot";
  const std::vector<Case> cases = {
      {overshoots, [](auto& t) { t.curve_keys[0].slope = 4.9f; }},
      {overshoots, [](auto& t) { t.curve_keys[2].slope = -0.1f; }},
      {overshoots, [](auto& t) { t.curve_keys[1].slope = NAN; }},
      {"curve 0: its keys do not rise in time", [](auto& t) { t.curve_keys[1].at = 0.0f; }},
      {"curve 0: its keys do not rise in time", [](auto& t) { t.curve_keys[1].at = NAN; }},
      {"curve 0: a share of it is not between 0 and 1", [](auto& t) { t.curve_keys[1].share = 1.5f; }},
      {"curve 0: it does not lead from (0, 0) to (1, 1)", [](auto& t) { t.curve_keys[2].share = 0.9f; }},
      {"curve 0: it has less than two keys, or they do not exist", [](auto& t) { t.curves[0].key_count = 1; }},
      {"curve 0: it has less than two keys, or they do not exist", [](auto& t) { t.curves[0].key_count = 4; }},
      {"transition 0 (node 'm'): its curve does not exist", [](auto& t) { t.transitions[0].curve = 1; }},
      {"transition 0 (node 'm'): only a cross-fade has a curve of its own",
       [](auto& t) { t.transitions[0].kind = GraphTransitionKind::dead_blend; }},
  };
  const Curved curved;
  const GraphTables sound = curved.b.tables(curved.machine);
  ASSERT_EQ(find_fault(sound).code, ErrorCode::ok);
  for (const Case& one : cases) {
    GraphTables tables = sound;
    one.change(tables);
    EXPECT_EQ(describe(find_fault(tables), tables), one.text);
  }
}

}  // namespace
}  // namespace sinew
