// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "tests/graph/graph_player.h"

namespace sinew {
namespace {

using test::GraphPlayer;

TEST(graph_nodes, a_clip_starts_at_its_offset_and_plays_at_its_speed) {
  GraphBuilder b;
  const GraphIndex speed = b.number("speed", 2.0f);
  GraphPlayer p(b, b.clip("walk", {.speed = 0.5f, .offset_s = 1.75f, .speed_parameter = speed}), {{7, 1.0}});
  p.advance(0.5);
  ASSERT_EQ(p.ops().size(), 1u);
  EXPECT_EQ(p.ops()[0], (PoseOp{.time_s = 0.25, .index = 7, .kind = PoseOpKind::sample}));
}

TEST(graph_nodes, a_still_clip_stands) {
  GraphBuilder b;
  GraphPlayer p(b, b.clip("pose"), {{0, 0.0}});
  p.advance(5.0);
  EXPECT_EQ(p.ops()[0].time_s, 0.0);
}

TEST(graph_nodes, a_line_mixes_two_neighbours_in_one_phase_of_the_mean_length) {
  GraphBuilder b;
  const GraphIndex speed = b.number("speed", 1.5f);
  const std::vector<GraphBlendPoint> points = {{0, 0, b.clip("idle")}, {1, 0, b.clip("walk")}, {3, 0, b.clip("run")}};
  GraphPlayer p(b, b.blend_space("gaits", {.x = speed}, points), {{0, 2.0}, {1, 1.0}, {2, 0.6}});
  const double length = 0.75 * 1.0 + 0.25 * 0.6;
  p.advance(0.5 * length);
  ASSERT_EQ(p.ops().size(), 3u);
  EXPECT_FLOAT_EQ(p.ops()[0].weight, 0.75f);
  EXPECT_FLOAT_EQ(p.ops()[1].weight, 0.25f);
  EXPECT_NEAR(p.ops()[0].time_s, 0.5 * 1.0, 1e-7);
  EXPECT_NEAR(p.ops()[1].time_s, 0.5 * 0.6, 1e-7);
  EXPECT_EQ(p.ops()[2].index, 2);
  p.set(speed, 9.0f);
  p.advance(0.0);
  EXPECT_EQ(p.ops().size(), 1u) << "the last point alone";
}

TEST(graph_nodes, a_plane_mixes_by_its_form) {
  for (const BlendSpaceKind form : {BlendSpaceKind::cartesian, BlendSpaceKind::directional, BlendSpaceKind::radial}) {
    GraphBuilder b;
    const GraphIndex x = b.number("x"), y = b.number("y");
    const std::vector<GraphBlendPoint> points = {
        {0, 0, b.clip("idle")}, {0, 1, b.clip("ahead")}, {0, -1, b.clip("back")}, {1, 0, b.clip("aside")}};
    GraphPlayer p(b, b.blend_space("gaits", {.x = x, .y = y, .form = form}, points),
                  {{0, 1.0}, {1, 1.0}, {2, 1.0}, {3, 1.0}});
    for (const GraphBlendPoint& point : points) {
      p.set(x, point.x);
      p.set(y, point.y);
      p.advance(0.0);
      ASSERT_EQ(p.ops().size(), 1u);
      EXPECT_EQ(p.ops()[0].index, point.node - points[0].node);
    }
    p.set(x, 0.4f);
    p.set(y, 0.3f);
    p.advance(0.1);
    EXPECT_GT(p.ops().size(), 3u);
    float sum = 0.0f;
    for (const PoseOp& op : p.ops().first(p.ops().size() - 1)) sum += op.weight;
    EXPECT_NEAR(sum, 1.0f, 1e-6f);
  }
}

TEST(graph_nodes, events_of_a_blend_space_come_from_all_clips_with_their_weights) {
  GraphBuilder b;
  const GraphIndex speed = b.number("speed", 0.25f);
  const std::vector<GraphBlendPoint> points = {{0, 0, b.clip("walk")}, {1, 0, b.clip("run")}};
  const std::vector<double> half_walk = {0.5}, half_run = {0.3};
  GraphPlayer p(b, b.blend_space("gaits", {.x = speed}, points), {{0, 1.0, half_walk}, {1, 0.6, half_run}});
  p.advance(0.9);  // one round
  ASSERT_EQ(p.log().size(), 2u);
  EXPECT_FLOAT_EQ(p.log()[0].weight, 0.75f);
  EXPECT_FLOAT_EQ(p.log()[1].weight, 0.25f);
  EXPECT_NEAR(seconds_of(p.log()[0].at), 0.45, 1e-6);
}

TEST(graph_nodes, events_weigh_as_the_fade_does_at_their_moment) {
  GraphBuilder b;
  const GraphIndex m = b.machine("m");
  const std::vector<double> at = {0.25};
  b.state(m, "a", b.clip("a"));
  const GraphIndex to = b.state(m, "b", b.clip("b"));
  b.transition(m, 0, {.duration_s = 1.0f, .to = to, .fade = GraphFade::linear}, {});
  GraphPlayer p(b, m, {{0, 1.0, at}, {1, 1.0, at}});
  p.advance(0.9);
  ASSERT_EQ(p.log().size(), 3u);
  EXPECT_EQ(p.log()[0].kind, GraphEventKind::state);
  EXPECT_FLOAT_EQ(p.log()[1].weight, 0.75f);
  EXPECT_FLOAT_EQ(p.log()[2].weight, 0.25f);
}

TEST(graph_nodes, a_select_starts_the_child_that_its_number_is_nearest_to) {
  GraphBuilder b;
  const GraphIndex which = b.number("which");
  const std::vector<GraphIndex> children = {b.clip("a"), b.clip("b"), b.external("ragdoll", 4)};
  GraphPlayer p(b, b.select("s", which, children), {{0, 1.0}, {1, 1.0}});
  p.advance(0.5);
  p.set(which, 0.5f);
  p.advance(0.25);
  EXPECT_EQ(p.ops()[0], (PoseOp{.time_s = 0.25, .index = 1, .kind = PoseOpKind::sample}));
  p.set(which, 99.0f);
  p.advance(0.25);
  EXPECT_EQ(p.ops()[0], (PoseOp{.index = 4, .kind = PoseOpKind::external}));
}

TEST(graph_nodes, layers_join_in_order_with_weight_and_mask) {
  GraphBuilder b;
  const GraphIndex aim = b.number("aim", 0.5f);
  const GraphIndex base = b.clip("base");
  const std::vector<GraphLayer> layers = {
      {.node = b.clip("upper"), .weight_parameter = aim, .mask = 2},
      {.weight = 0.0f, .node = b.clip("unseen")},
      {.node = b.clip("level"), .mask = 1, .kind = GraphLayerKind::overlay_model},
      {.weight = 2.0f, .node = b.clip("breath"), .kind = GraphLayerKind::additive},
      {.node = b.clip("other"), .kind = GraphLayerKind::mean},
  };
  GraphPlayer p(b, b.layers("body", base, layers), {{0, 1.0}, {1, 1.0}, {2, 1.0}, {3, 1.0}, {4, 1.0}, {5, 1.0}});
  p.advance(0.25);
  PoseProgram expected;
  expected.sample(0, 0.25)
      .sample(1, 0.25, 0.5f, 2)
      .overlay()
      .sample(3, 0.25, 1.0f, 1)
      .overlay_model()
      .sample(4, 0.25, 2.0f)
      .add_to_rest()
      .sample(5, 0.25)
      .mean(2, 1.0f, 0.001);
  EXPECT_TRUE(std::equal(p.ops().begin(), p.ops().end(), expected.ops().begin(), expected.ops().end()));
  EXPECT_TRUE(p.graph().room().overlays_in_model_space);
  EXPECT_LE(pose_slots(p.ops()), p.graph().room().slots);
}

TEST(graph_nodes, layers_that_fade_are_made_one_pose_each) {
  GraphBuilder b;
  const GraphIndex m = b.machine("m");
  const GraphLayer layer{.node = b.clip("breath"), .kind = GraphLayerKind::additive};
  b.state(m, "a", b.layers("with", b.clip("a"), std::vector{layer}));
  const GraphIndex to = b.state(m, "b", b.clip("b"));
  b.transition(m, 0, {.duration_s = 1.0f, .to = to, .fade = GraphFade::linear}, {});
  GraphPlayer p(b, m, {{0, 1.0}, {1, 1.0}, {2, 1.0}});
  p.advance(0.25);
  ASSERT_EQ(p.ops().size(), 5u);
  EXPECT_EQ(p.ops()[2].kind, PoseOpKind::add_to_rest);
  EXPECT_FLOAT_EQ(p.ops()[2].weight, 0.75f) << "the sum fades, not its parts";
  EXPECT_FLOAT_EQ(p.ops()[3].weight, 0.25f);
}

TEST(graph_nodes, machines_take_the_entry_rule_that_holds) {
  for (const float speed : {0.0f, 1.0f}) {
    GraphBuilder b;
    const GraphIndex number = b.number("speed", speed);
    const GraphIndex m = b.machine("m");
    b.state(m, "idle", b.clip("idle"));
    const GraphIndex run = b.state(m, "run", b.clip("run"));
    b.entry(m, {.to = run}, {when_above(number, 0.5f)});
    GraphPlayer p(b, m, {{0, 1.0}, {1, 1.0}});
    EXPECT_EQ(p.active(), speed > 0.5f ? "run" : "idle");
  }
}

/// Phases of two clips in a fade.
TEST(graph_nodes, a_locked_fade_keeps_one_phase_and_passes_from_one_length_to_the_other) {
  GraphBuilder b;
  const GraphIndex m = b.machine("m");
  b.state(m, "walk", b.clip("walk"));
  const GraphIndex run = b.state(m, "run", b.clip("run"));
  b.transition(m, 0, {.duration_s = 0.5f, .to = run, .fade = GraphFade::linear, .sync = GraphSync::locked},
               {when_in_state_for(0.3f)});
  GraphPlayer p(b, m, {{0, 1.2}, {1, 0.7}});
  p.advance(0.3);
  double before = 0.25;
  for (int i = 0; i < 29; ++i) {
    p.advance(1.0 / 60.0);
    ASSERT_EQ(p.ops().size(), 3u);
    const double walk = p.ops()[0].time_s / 1.2, share = static_cast<double>(p.ops()[1].weight);
    EXPECT_NEAR(walk, p.ops()[1].time_s / 0.7, 1e-6);
    const double rounds = walk - before < 0.0 ? walk - before + 1.0 : walk - before;
    EXPECT_NEAR(1.0 / 60.0 / rounds, 1.2 + share * (0.7 - 1.2), 0.012) << "within a cell of the weighted mean";
    before = walk;
  }
}

TEST(graph_nodes, inactive_machines_and_states_take_no_part) {
  GraphBuilder b;
  const GraphIndex m = b.machine("m");
  for (int i = 0; i < 40; ++i) b.state(m, "s", b.clip("c" + std::to_string(i)));
  for (GraphIndex i = 0; i < 40; ++i)
    b.transition(m, i, {.to = static_cast<GraphIndex>((i + 1) % 40)}, {when_in_state_for(1.0f)});
  GraphPlayer p(b, m, std::vector<GraphClip>(40, GraphClip{0, 1.0}));
  p.advance(39.5);
  EXPECT_EQ(p.ops().size(), 1u);
  EXPECT_EQ(p.log().size(), 39u);
}

}  // namespace
}  // namespace sinew
