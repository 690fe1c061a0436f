// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/graph/graph_player.h"

namespace sinew {
namespace {

using test::GraphPlayer;

/// States A, B and C, of clips of 2 s.
struct ThreeStates {
  GraphBuilder b;
  GraphIndex machine, go, stop;
  GraphIndex states[3];

  explicit ThreeStates(GraphMachine settings = {}) {
    machine = b.machine("machine", settings);
    go = b.flag("go");
    stop = b.flag("stop");
    const char* names[] = {"A", "B", "C"};
    for (int i = 0; i < 3; ++i) states[i] = b.state(machine, names[i], b.clip(names[i]));
  }
  void arrow(int from, int to, GraphTransition settings, std::initializer_list<GraphCondition> conditions) {
    settings.to = states[to];
    b.transition(machine, states[from], settings, conditions);
  }
  GraphPlayer player() const { return GraphPlayer(b, machine, {{0, 2.0}, {1, 2.0}, {2, 2.0}}); }
};

TEST(state_machine, a_transition_that_waits_blocks_none_of_lower_priority) {
  ThreeStates s;
  s.arrow(0, 1, {.priority = 1}, {when_played(1)});
  s.arrow(0, 2, {.priority = 2}, {when_on(s.go)});
  GraphPlayer p = s.player();
  p.advance(0.6);
  EXPECT_EQ(p.active(), "A");
  p.set(s.go, 1);
  p.advance(0.2);
  EXPECT_EQ(p.active(), "C");
}

TEST(state_machine, the_end_of_a_clip_is_exact) {
  ThreeStates s;
  s.arrow(0, 1, {}, {when_played(1)});
  s.arrow(0, 2, {.priority = 9}, {when_on(s.go)});
  GraphPlayer p = s.player();
  p.advance(0.1, 19);
  EXPECT_EQ(p.active(), "A");
  p.advance(0.1);
  EXPECT_EQ(p.active(), "B");
  ASSERT_EQ(p.log().size(), 1u);
  EXPECT_EQ(p.log()[0].at, 2 * kTicksPerSecond);
}

TEST(state_machine, the_smallest_priority_wins_and_the_last_declared_among_equals) {
  for (const bool equal : {false, true}) {
    ThreeStates s;
    s.arrow(0, 2, {.priority = equal ? 1 : 2}, {when_on(s.go)});
    s.arrow(0, 1, {.priority = 1}, {when_on(s.go)});
    GraphPlayer p = s.player();
    p.set(s.go, 1);
    p.advance(0.1);
    EXPECT_EQ(p.active(), "B");
  }
}

TEST(state_machine, transitions_from_any_state_join_by_priority_and_do_not_restart_the_state) {
  ThreeStates s;
  s.arrow(0, 1, {.priority = 1}, {when_on(s.go)});
  s.b.transition_from_any(s.machine, {.priority = 0, .to = s.states[2]}, {when_on(s.go)});
  GraphPlayer p = s.player();
  p.set(s.go, 1);
  p.advance(0.5);
  EXPECT_EQ(p.active(), "C");
  EXPECT_EQ(p.log().size(), 1u);
}

TEST(state_machine, a_request_is_obeyed_whatever_conditions_say) {
  ThreeStates s;
  s.arrow(0, 1, {.priority = 1}, {when_played(1)});
  s.arrow(0, 2, {.priority = 2}, {when_on(s.go)});
  GraphPlayer p = s.player();
  p.advance(0.1);
  p.set(s.go, 1);
  ASSERT_EQ(request_state(p.graph(), p.state(), s.machine, kNextState), ErrorCode::ok);
  p.advance(0.0);
  EXPECT_EQ(p.active(), "B");
  ASSERT_EQ(request_state(p.graph(), p.state(), s.machine, s.states[0]), ErrorCode::ok);
  p.set(s.go, 0);
  p.advance(0.1);
  EXPECT_EQ(p.active(), "A");
}

TEST(state_machine, one_trigger_serves_one_moment) {
  ThreeStates s;
  const GraphIndex jump = s.b.trigger("jump");
  s.arrow(0, 1, {}, {when_triggered(jump)});
  s.arrow(1, 2, {}, {when_triggered(jump)});
  GraphPlayer p = s.player();
  p.trigger(jump);
  p.advance(1.0);
  EXPECT_EQ(p.active(), "B");
  p.trigger(jump);
  p.advance(0.1);
  EXPECT_EQ(p.active(), "C");
}

TEST(state_machine, phases_are_moments) {
  ThreeStates s;
  s.arrow(0, 1, {}, {when_at_phase(0.25f), when_on(s.go)});
  s.arrow(1, 2, {}, {});
  GraphPlayer p = s.player();
  p.advance(0.6);  // the moment has passed
  p.set(s.go, 1);
  p.advance(1.8);
  EXPECT_EQ(p.active(), "A");
  p.advance(0.1);  // 2.5 s
  EXPECT_EQ(p.log().front().at, 5 * kTicksPerSecond / 2);
}

/// A fade from A to B of 1 s that `by` may interrupt; B goes to C on "go", and so does A on "stop".
std::string_view interrupted(GraphInterruption by, bool from_source, bool ordered = false, int priority = 0) {
  ThreeStates s;
  s.arrow(0, 1, {.duration_s = 1.0f, .priority = 1, .interruption = by, .ordered = ordered}, {});
  s.arrow(0, 2, {.priority = priority}, {when_on(s.stop)});
  s.arrow(1, 2, {}, {when_on(s.go)});
  GraphPlayer p = s.player();
  p.advance(0.25);
  p.set(from_source ? s.stop : s.go, 1);
  p.advance(0.25);
  return p.active() == "C" ? "interrupted" : "not";
}

TEST(state_machine, fades_are_interrupted_by_the_transitions_that_may) {
  using I = GraphInterruption;
  EXPECT_EQ(interrupted(I::none, true), "not");
  EXPECT_EQ(interrupted(I::none, false), "not");
  EXPECT_EQ(interrupted(I::source, true), "interrupted");
  EXPECT_EQ(interrupted(I::source, false), "not");
  EXPECT_EQ(interrupted(I::target, true), "not");
  EXPECT_EQ(interrupted(I::target, false), "interrupted");
  for (const auto both : {I::source_then_target, I::target_then_source}) {
    EXPECT_EQ(interrupted(both, true), "interrupted");
    EXPECT_EQ(interrupted(both, false), "interrupted");
  }
}

TEST(state_machine, an_ordered_fade_yields_to_smaller_priorities_of_its_source_only) {
  EXPECT_EQ(interrupted(GraphInterruption::source, true, true, 0), "interrupted");
  EXPECT_EQ(interrupted(GraphInterruption::source, true, true, 1), "not");
  EXPECT_EQ(interrupted(GraphInterruption::source, true, true, 2), "not");
  EXPECT_EQ(interrupted(GraphInterruption::target, false, true, 2), "interrupted");
}

TEST(state_machine, a_fade_that_nothing_interrupts_lets_waiting_transitions_in_at_its_end) {
  ThreeStates s;
  s.arrow(0, 1, {.duration_s = 0.5f, .interruption = GraphInterruption::none}, {});
  s.arrow(1, 2, {.duration_s = 0.5f}, {});
  GraphPlayer p = s.player();
  p.advance(3.0);
  ASSERT_EQ(p.log().size(), 2u);
  EXPECT_EQ(p.log()[1].at, kTicksPerSecond / 2);
}

TEST(state_machine, weights_of_fades_sum_to_1_and_what_weighs_nothing_is_not_written) {
  ThreeStates s;
  s.arrow(0, 1, {.duration_s = 1.0f, .fade = GraphFade::linear}, {when_on(s.go)});
  s.arrow(1, 2, {.duration_s = 1.0f, .fade = GraphFade::linear}, {when_on(s.stop)});
  GraphPlayer p = s.player();
  p.advance(0.25);
  EXPECT_EQ(p.ops().size(), 1u);
  p.set(s.go, 1);
  p.advance(0.0);
  EXPECT_EQ(p.ops().size(), 1u) << "B has weight 0";
  p.advance(0.5);
  ASSERT_EQ(p.ops().size(), 3u);
  EXPECT_EQ(p.ops()[2].kind, PoseOpKind::mean);
  p.set(s.stop, 1);
  p.advance(0.25);
  ASSERT_EQ(p.ops().size(), 4u);
  EXPECT_FLOAT_EQ(p.ops()[0].weight, 0.25f * 0.75f);
  EXPECT_FLOAT_EQ(p.ops()[1].weight, 0.75f * 0.75f);
  EXPECT_FLOAT_EQ(p.ops()[2].weight, 0.25f);
  EXPECT_DOUBLE_EQ(p.ops()[2].time_s, 0.25);
  p.advance(0.75);
  EXPECT_EQ(p.ops().size(), 1u);
}

TEST(state_machine, a_machine_without_room_forgets_the_state_that_weighs_least) {
  ThreeStates s({.fades = 1});
  s.arrow(0, 1, {.duration_s = 1.0f, .fade = GraphFade::linear}, {when_on(s.go)});
  s.arrow(1, 2, {.duration_s = 1.0f, .fade = GraphFade::linear}, {when_on(s.stop)});
  GraphPlayer p = s.player();
  p.set(s.go, 1);
  p.advance(0.75);
  p.set(s.stop, 1);
  p.advance(0.5);
  ASSERT_EQ(p.ops().size(), 3u);
  EXPECT_EQ(p.ops()[0].index, 1);
  EXPECT_EQ(p.ops()[1].index, 2);
}

TEST(state_machine, states_that_always_go_on_change_1000_times_a_second) {
  ThreeStates s;
  s.arrow(0, 1, {}, {});
  s.arrow(1, 0, {}, {});
  s.b.transition_from_any(s.machine, {.to = s.states[2]}, {when_on(s.go)});
  GraphPlayer p = s.player();
  p.advance(1.0);
  EXPECT_EQ(p.log().size(), 1001u);
}

TEST(state_machine, backwards_clips_turn_round_and_states_stand_still) {
  ThreeStates s;
  s.arrow(0, 1, {}, {when_in_state_for(0.5f)});
  s.arrow(1, 2, {}, {when_on(s.go)});
  GraphPlayer p = s.player();
  p.advance(0.25);
  p.advance(-1.0);
  EXPECT_DOUBLE_EQ(p.ops()[0].time_s, 1.25);
  p.advance(0.24);
  EXPECT_EQ(p.active(), "A");
  p.advance(0.01);
  EXPECT_EQ(p.active(), "B");
}

}  // namespace
}  // namespace sinew
