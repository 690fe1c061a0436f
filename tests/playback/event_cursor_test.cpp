// SPDX-License-Identifier: MIT
#include "runtime/playback/event_cursor.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <vector>

namespace sinew {
namespace {

using Indices = std::vector<std::size_t>;

Indices crossed(const PlaybackStep& step, const std::vector<double>& times_s) {
  Indices seen;
  for (EventCursor cursor(step, times_s); const auto event = cursor.next();) seen.push_back(*event);
  return seen;
}

TEST(event_cursor, an_event_belongs_to_the_step_that_ends_on_it) {
  PlaybackClock clock(1.0);
  const std::vector<double> times = {0.25, 0.5};
  EXPECT_EQ(crossed(clock.advance(0.25), times), Indices{0});
  EXPECT_EQ(crossed(clock.advance(0.25), times), Indices{1});
  EXPECT_EQ(crossed(clock.advance(0.25), times), Indices{});
}

TEST(event_cursor, the_first_step_owns_the_place_where_it_starts) {
  PlaybackClock clock(1.0);
  const std::vector<double> times = {0.0, 0.5, 1.0};
  EXPECT_EQ(crossed(clock.advance(0.25), times), Indices{0});
  EXPECT_EQ(crossed(clock.advance(0.25), times), Indices{1});
  clock.seek(0.5);
  EXPECT_EQ(crossed(clock.advance(0.0), times), Indices{1});
  EXPECT_EQ(crossed(clock.advance(0.0), times), Indices{});
}

TEST(event_cursor, G12_a_loop_crosses_the_events_of_the_end_and_then_those_of_the_start) {
  PlaybackClock clock(1.0);
  const std::vector<double> times = {0.0, 0.5, 1.0};
  EXPECT_EQ(crossed(clock.advance(0.75), times), (Indices{0, 1}));
  EXPECT_EQ(crossed(clock.advance(0.25), times), (Indices{2, 0}));
  EXPECT_EQ(crossed(clock.advance(0.25), times), Indices{});
  EXPECT_EQ(crossed(clock.advance(2.0), times), (Indices{1, 2, 0, 1, 2, 0}));
}

TEST(event_cursor, backwards_the_order_turns_round) {
  PlaybackClock clock(1.0, PlayMode::loop, -1.0);
  const std::vector<double> times = {0.0, 0.5, 1.0};
  EXPECT_EQ(crossed(clock.advance(0.75), times), (Indices{0, 1}));
  EXPECT_EQ(crossed(clock.advance(0.25), times), (Indices{0, 2}));
  EXPECT_EQ(crossed(clock.advance(1.25), times), (Indices{1, 0, 2}));
}

TEST(event_cursor, turning_round_on_an_event_does_not_cross_it_again) {
  PlaybackClock clock(1.0);
  const std::vector<double> times = {0.5};
  EXPECT_EQ(crossed(clock.advance(0.5), times), Indices{0});
  clock.set_speed(-1.0);
  EXPECT_EQ(crossed(clock.advance(0.25), times), Indices{});
  clock.set_speed(1.0);
  EXPECT_EQ(crossed(clock.advance(0.25), times), Indices{0});
}

TEST(event_cursor, ping_pong_crosses_inner_events_each_way_and_end_events_once) {
  PlaybackClock clock(1.0, PlayMode::ping_pong);
  const std::vector<double> times = {0.0, 0.25, 1.0};
  EXPECT_EQ(crossed(clock.advance(4.0), times), (Indices{0, 1, 2, 1, 0, 1, 2, 1, 0}));
}

TEST(event_cursor, clamp_crosses_the_end_once) {
  for (const PlayMode mode : {PlayMode::clamp, PlayMode::once}) {
    PlaybackClock clock(1.0, mode);
    const std::vector<double> times = {0.5, 1.0};
    EXPECT_EQ(crossed(clock.advance(7.0), times), (Indices{0, 1}));
    EXPECT_EQ(crossed(clock.advance(7.0), times), Indices{});
  }
}

TEST(event_cursor, a_clip_without_length_crosses_its_event_once) {
  for (const PlayMode mode : {PlayMode::loop, PlayMode::clamp, PlayMode::ping_pong, PlayMode::once}) {
    PlaybackClock clock(0.0, mode);
    const std::vector<double> times = {0.0};
    EXPECT_EQ(crossed(clock.advance(1.0), times), Indices{0});
    EXPECT_EQ(crossed(clock.advance(1.0), times), Indices{});
  }
}

TEST(event_cursor, nothing_to_cross_without_events) {
  PlaybackClock clock(1.0);
  EXPECT_EQ(crossed(clock.advance(1e12), {}), Indices{});
}

/// The results of a cursor's next(), at most `most` of them.
struct Told {
  Indices events;
  std::uint64_t rounds_left_out = 0;
  bool ended = false;
};

Told told(const PlaybackStep& step, const std::vector<double>& times_s, std::size_t most) {
  EventCursor cursor(step, times_s);
  Told seen{{}, cursor.rounds_left_out(), false};
  while (!seen.ended && seen.events.size() < most) {
    const auto event = cursor.next();
    seen.ended = !event;
    if (event) seen.events.push_back(*event);
  }
  return seen;
}

TEST(event_cursor, a_step_over_no_end_of_rounds_tells_a_bounded_number_of_crossings) {
  const std::vector<double> times = {0.0, 5e-31};
  const std::size_t most = 4 * EventCursor::kMostRounds;
  for (const double dt_s : {1.0 / 60.0, -1.0 / 60.0, 1e200})
    for (const PlayMode mode : {PlayMode::loop, PlayMode::ping_pong}) {
      PlaybackClock clock(1e-30, mode);
      clock.advance(2e-31);
      for (int frame = 0; frame < 3; ++frame) {
        const Told seen = told(clock.advance(dt_s), times, most + 1);
        EXPECT_TRUE(seen.ended) << dt_s;
        EXPECT_GT(seen.rounds_left_out, std::uint64_t{1} << 62) << dt_s;
      }
    }
}

TEST(event_cursor, rounds_beyond_those_that_are_told_are_counted) {
  const std::uint64_t most = EventCursor::kMostRounds;
  const std::vector<double> times = {0.25, 0.75};
  for (const double sign : {1.0, -1.0}) {
    PlaybackClock clock(1.0, PlayMode::loop, sign), whole = clock;
    clock.advance(0.5);
    const Told seen = told(clock.advance(static_cast<double>(most) + 99.0), times, 4 * most);
    EXPECT_EQ(seen.rounds_left_out, 100u);  // of kMostRounds + 100 rounds, the first and the last partial
    ASSERT_EQ(seen.events.size(), 2 * (most - 1));
    const std::size_t next = sign > 0.0 ? 1 : 0;
    for (std::size_t i = 0; i < seen.events.size(); ++i) ASSERT_EQ(seen.events[i], (next + i) % 2) << i;
    whole.advance(0.5);
    EXPECT_EQ(told(whole.advance(static_cast<double>(most) - 1.0), times, 4 * most).rounds_left_out, 0u);
  }
}

TEST(event_cursor, a_step_that_was_refused_crosses_nothing) {
  PlaybackClock clock(1.0);
  const std::vector<double> times = {0.0, 0.5, 1.0};
  EXPECT_EQ(crossed(clock.advance(std::numeric_limits<double>::quiet_NaN()), times), Indices{});
  EXPECT_EQ(crossed(clock.advance(0.5), times), (Indices{0, 1}));
  EXPECT_EQ(crossed(clock.advance(std::numeric_limits<double>::infinity()), times), Indices{});
}

// Any division of play into steps gives the same events in the same order, since each belongs to exactly one step.
class CutPlay : public ::testing::TestWithParam<PlayMode> {};

TEST_P(CutPlay, steps_of_any_length_see_what_one_long_step_sees) {
  std::mt19937 random(20240601);
  const std::vector<double> times = {0.0, 0.125, 0.5, 0.5, 0.875, 1.0};
  for (int round = 0; round < 300; ++round) {
    const double sign = round % 2 == 0 ? 1.0 : -1.0;
    PlaybackClock whole(1.0, GetParam(), sign), cut(1.0, GetParam(), sign);
    Indices seen;
    double total_s = 0.0;
    while (total_s < 5.0) {  // multiples of 1/16: every sum is exact and many steps end on an event
      const double dt_s = static_cast<double>(random() % 24) / 16.0;
      total_s += dt_s;
      for (const std::size_t event : crossed(cut.advance(dt_s), times)) seen.push_back(event);
    }
    ASSERT_EQ(seen, crossed(whole.advance(total_s), times)) << "total " << total_s * sign;
  }
}

INSTANTIATE_TEST_SUITE_P(modes, CutPlay,
                         ::testing::Values(PlayMode::loop, PlayMode::clamp, PlayMode::ping_pong, PlayMode::once));

TEST(event_cursor, hours_of_frames_cross_an_event_once_per_round) {
  PlaybackClock clock(0.9);
  const std::vector<double> times = {0.1, 0.8};
  std::uint64_t seen = 0;
  for (int frame = 0; frame < 10 * 3600 * 60; ++frame) seen += crossed(clock.advance(1.0 / 60.0), times).size();
  const std::uint64_t rounds = static_cast<std::uint64_t>(clock.rounds());
  EXPECT_GE(seen, 2 * rounds);
  EXPECT_LE(seen, 2 * rounds + 2);
  EXPECT_NEAR(static_cast<double>(rounds), 36000.0 / 0.9, 1.0);
}

}  // namespace
}  // namespace sinew
