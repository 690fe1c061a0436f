// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "tests/graph/graph_player.h"
#include "tests/support/allocation_counter.h"

namespace sinew {
namespace {

using test::GraphPlayer;

/// Events of clips, without those of machines.
std::vector<GraphEvent> clip_events(const GraphPlayer& player) {
  std::vector<GraphEvent> events;
  for (const GraphEvent& e : player.log())
    if (e.kind == GraphEventKind::clip) events.push_back(e);
  return events;
}

TEST(graph_time, whole_numbers_are_those_of_the_library) {
  const double below_half = std::nextafter(0.5, 0.0), large = 0x1p52 - 0.5;
  for (const double x : {0.0, below_half, 0.5, 1.5, 2.5, 1.0 - 0x1p-53, 7.0, 1e9 + 0.5, large, 0x1p52 + 1.0, 0x1p62})
    for (const double signed_x : {x, -x}) {
      EXPECT_EQ(nearest_whole(signed_x), std::llround(signed_x)) << signed_x;
      EXPECT_EQ(whole_below(signed_x), std::floor(signed_x)) << signed_x;
    }
}

TEST(graph_time, ten_seconds_of_a_short_clip_tell_every_event) {
  GraphBuilder b;
  const GraphIndex root = b.clip("step");
  const std::vector<double> times = {0.0, 0.1, 0.3};
  GraphPlayer long_step(b, root, {{0, 0.4, times}}), short_steps(b, root, {{0, 0.4, times}});
  long_step.advance(10.0);
  short_steps.advance(0.001, 10000);
  EXPECT_EQ(clip_events(long_step).size(), 76u) << "25 rounds, and the start of the next one";
  EXPECT_EQ(long_step.log(), short_steps.log());
  EXPECT_TRUE(std::equal(long_step.ops().begin(), long_step.ops().end(), short_steps.ops().begin()));
}

TEST(graph_time, events_beyond_the_room_are_counted) {
  GraphBuilder b;
  const GraphIndex root = b.clip("step");
  const std::vector<double> times = {0.1};
  GraphPlayer player(b, root, {{0, 0.4, times}}, 3);
  player.advance(4.0);
  EXPECT_EQ(player.step().event_count, 3u);
  EXPECT_EQ(player.step().events_left_out, 7u);
}

TEST(graph_time, a_clip_that_stays_at_its_end_tells_its_events_once) {
  GraphBuilder b;
  const GraphIndex root = b.clip("jump", {.loop = false});
  const std::vector<double> times = {0.0, 0.4};
  GraphPlayer player(b, root, {{0, 0.4, times}});
  player.advance(10.0);
  EXPECT_EQ(player.log().size(), 2u);
  EXPECT_DOUBLE_EQ(player.ops()[0].time_s, 0.4);
  player.advance(-0.1);
  EXPECT_NEAR(player.ops()[0].time_s, 0.3, 1e-12);
}

TEST(graph_time, backwards_events_come_in_the_opposite_order) {
  GraphBuilder turned, plain;
  const GraphIndex back = turned.clip("walk", {.speed = -1.0f}), root = plain.clip("walk");
  const std::vector<double> times = {0.1, 0.3};
  GraphPlayer player(turned, back, {{0, 0.4, times}}), rewound(plain, root, {{0, 0.4, times}});
  player.advance(0.4);
  rewound.advance(-0.4);
  for (const GraphPlayer* p : {&player, &rewound}) {
    ASSERT_EQ(p->log().size(), 2u);
    EXPECT_EQ(p->log()[0].index, 1u);
    EXPECT_EQ(p->log()[1].index, 0u);
  }
  EXPECT_EQ(rewound.log()[1].at, -3 * kTicksPerSecond / 10);
}

/// Machines in machines, fades that interrupt each other and play in step, events, and transitions of each kind.
struct Busy {
  GraphBuilder b;
  GraphIndex root, speed;
  std::vector<double> steps = {0.0, 0.2, 0.5};

  Busy() {
    speed = b.number("speed", 1.3f);
    const GraphIndex feet = b.machine("feet");
    const GraphIndex walk = b.state(feet, "walk", b.clip("walk"));
    const GraphIndex run = b.state(feet, "run", b.clip("run", {.speed_parameter = speed}));
    b.transition(feet, walk, {.duration_s = 0.31f, .to = run, .sync = GraphSync::locked}, {when_played(1.5f)});
    b.transition(feet, run, {.duration_s = 0.17f, .to = walk, .sync = GraphSync::locked}, {when_at_phase(0.4f)});

    const GraphIndex arms = b.machine("arms");
    const GraphIndex rest = b.state(arms, "rest", b.clip("rest"));
    const GraphIndex wave = b.state(arms, "wave", b.clip("wave", {.loop = false}));
    b.transition(arms, rest, {.duration_s = 0.4f, .to = wave}, {when_in_state_for(0.123f)});
    b.transition(arms, wave, {.duration_s = 0.4f, .to = rest, .fade = GraphFade::linear}, {when_played(0.3f)});

    const GraphIndex other = b.machine("whole");
    const GraphLayer layer{.node = arms, .mask = 0};
    const GraphIndex up = b.state(other, "up", b.layers("body", feet, std::vector{layer}));
    const GraphIndex down = b.state(other, "down", b.clip("down"));
    b.transition(other, up, {.duration_s = 0.2f, .to = down}, {when_in_state_for(1.7f)});
    b.transition(other, down, {.duration_s = 0.25f, .to = up}, {when_in_state_for(0.111f)});
    root = other;
  }
  GraphPlayer player() const {
    return GraphPlayer(b, root, {{0, 0.9, steps}, {1, 0.6, steps}, {2, 2.0}, {3, 0.8, steps}, {4, 0.7, steps}});
  }
};

TEST(graph_time, results_do_not_depend_on_how_time_is_cut) {
  const Busy busy;
  GraphPlayer one = busy.player(), milliseconds = busy.player(), frames = busy.player(), uneven = busy.player();
  for (int second = 0; second < 12; ++second) {
    one.advance(1.0);
    milliseconds.advance(0.001, 1000);
    frames.advance(1.0 / 60.0, 60);
    for (int i = 1; i <= 4; ++i) uneven.advance(0.1 * i);
  }
  EXPECT_GT(one.log().size(), 150u);
  for (GraphPlayer* other : {&milliseconds, &frames, &uneven}) {
    EXPECT_EQ(one.log(), other->log());
    ASSERT_EQ(one.ops().size(), other->ops().size());
    for (std::size_t i = 0; i < one.ops().size(); ++i) EXPECT_EQ(one.ops()[i], other->ops()[i]) << i;
  }
}

TEST(graph_time, steps_shorter_than_a_tick_add_up) {
  GraphBuilder b;
  GraphPlayer player(b, b.clip("walk"), {{0, 1.0}});
  player.advance(0.4 / static_cast<double>(kTicksPerSecond), 1000);
  EXPECT_NEAR(player.ops()[0].time_s * static_cast<double>(kTicksPerSecond), 400.0, 1.0);
}

TEST(graph_time, an_update_allocates_nothing) {
  const Busy busy;
  GraphPlayer player = busy.player();
  PoseProgram program;
  GraphStep step;
  std::vector<GraphEvent> events(4096);
  const UpdateGraphJob job{
      &player.graph(), &player.clips(), player.values(), player.state(), 0.5, &program, events, &step};
  const auto before = test::allocation_count();
  for (int i = 0; i < 20; ++i) EXPECT_EQ(run(job), ErrorCode::ok);
  EXPECT_EQ(test::allocation_count(), before);
}

TEST(graph_time, misuse_is_refused_and_changes_nothing) {
  const Busy busy;
  GraphPlayer player = busy.player();
  const std::vector<std::byte> before(player.state().begin(), player.state().end());
  PoseProgram program;
  GraphStep step;
  const UpdateGraphJob good{
      &player.graph(), &player.clips(), player.values(), player.state(), 0.5, &program, {}, &step};
  const auto refused = [&](auto change) {
    UpdateGraphJob job = good;
    change(job);
    return run(job);
  };
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(refused([](auto& job) { job.dt_s = kNan; }), ErrorCode::not_finite);
  EXPECT_EQ(refused([](auto& job) { job.dt_s = 4000.0; }), ErrorCode::too_large);
  EXPECT_EQ(refused([](auto& job) { job.state = job.state.first(8); }), ErrorCode::size_mismatch);
  EXPECT_EQ(refused([](auto& job) { job.parameters = {}; }), ErrorCode::size_mismatch);
  EXPECT_EQ(refused([](auto& job) { job.step = nullptr; }), ErrorCode::size_mismatch);
  const GraphClipSet few = *GraphClipSet::make(std::vector<GraphClip>{{0, 1.0}});
  EXPECT_EQ(refused([&](auto& job) { job.clips = &few; }), ErrorCode::size_mismatch);
  std::vector<float> bad = player.values();
  bad[0] = std::numeric_limits<float>::infinity();
  EXPECT_EQ(refused([&](auto& job) { job.parameters = bad; }), ErrorCode::not_finite);
  std::vector<std::uint64_t> zeros(player.state().size() / 8);
  EXPECT_EQ(refused([&](auto& job) { job.state = std::as_writable_bytes(std::span(zeros)); }), ErrorCode::wrong_plan);
  EXPECT_TRUE(std::equal(before.begin(), before.end(), player.state().begin()));
}

TEST(graph_time, clips_with_times_that_cannot_be_are_refused) {
  const std::vector<double> falling = {0.3, 0.1}, outside = {1.5};
  const auto made = [](GraphClip clip) {
    const auto set = GraphClipSet::make(std::vector{clip});
    return set ? ErrorCode::ok : set.error();
  };
  EXPECT_EQ(made({0, 1.0, falling}), ErrorCode::times_not_increasing);
  EXPECT_EQ(made({0, 1.0, outside}), ErrorCode::times_not_increasing);
  EXPECT_EQ(made({0, -1.0}), ErrorCode::too_large);
  EXPECT_EQ(made({0, 7000.0}), ErrorCode::too_large);
  EXPECT_EQ(made({0, std::nan("")}), ErrorCode::not_finite);
}

}  // namespace
}  // namespace sinew
