// SPDX-License-Identifier: MIT
#include "runtime/playback/playback_clock.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace sinew {
namespace {

constexpr double kFrame = 1.0 / 60.0;

TEST(playback_clock, starts_at_zero_and_moves_by_speed_times_dt) {
  PlaybackClock clock(2.0, PlayMode::loop, 1.5);
  EXPECT_EQ(clock.time_s(), 0.0);
  clock.advance(0.5);
  EXPECT_EQ(clock.time_s(), 0.75);
  clock.set_speed(0.0);
  clock.advance(100.0);
  EXPECT_EQ(clock.time_s(), 0.75);
}

TEST(playback_clock, G12_loop_shows_the_seam_once_and_as_the_start) {
  PlaybackClock clock(1.0);
  clock.advance(0.75);
  clock.advance(0.25);
  EXPECT_EQ(clock.time_s(), 0.0);
  EXPECT_EQ(clock.rounds(), 1);
  clock.advance(0.25);
  EXPECT_EQ(clock.time_s(), 0.25);
}

TEST(playback_clock, G12_loop_keeps_what_lies_beyond_the_seam) {
  PlaybackClock clock(1.0);
  clock.advance(3.25);
  EXPECT_EQ(clock.time_s(), 0.25);
  EXPECT_EQ(clock.rounds(), 3);
}

TEST(playback_clock, loop_runs_backwards_through_the_seam) {
  PlaybackClock clock(1.0, PlayMode::loop, -1.0);
  clock.advance(0.25);
  EXPECT_EQ(clock.time_s(), 0.75);
  EXPECT_EQ(clock.rounds(), -1);
  clock.advance(0.75);
  EXPECT_EQ(clock.time_s(), 0.0);
  EXPECT_EQ(clock.rounds(), -1);
}

TEST(playback_clock, a_whole_round_backwards_ends_at_zero_without_a_sign) {
  PlaybackClock clock(2.0, PlayMode::loop, -1.0);
  clock.advance(2.0);
  EXPECT_EQ(clock.time_s(), 0.0);
  EXPECT_FALSE(std::signbit(clock.time_s()));
}

TEST(playback_clock, a_hair_before_the_seam_stays_inside_the_clip) {
  PlaybackClock clock(1.0, PlayMode::loop, -1.0);
  clock.advance(1e-20);
  EXPECT_GE(clock.time_s(), 0.0);
  EXPECT_LT(clock.time_s(), 1.0);
  EXPECT_EQ(clock.rounds(), 0);
  clock.advance(0.25);
  EXPECT_EQ(clock.time_s(), 0.75);
  EXPECT_EQ(clock.rounds(), -1);
}

TEST(playback_clock, ping_pong_goes_forth_and_back) {
  PlaybackClock clock(1.0, PlayMode::ping_pong);
  const double expected[] = {0.375, 0.75, 0.875, 0.5, 0.125, 0.25, 0.625, 1.0, 0.625};
  for (const double time_s : expected) {
    clock.advance(0.375);
    EXPECT_EQ(clock.time_s(), time_s);
  }
  EXPECT_EQ(clock.rounds(), 1);
}

TEST(playback_clock, ping_pong_runs_backwards_from_the_start) {
  PlaybackClock clock(1.0, PlayMode::ping_pong, -1.0);
  clock.advance(0.25);
  EXPECT_EQ(clock.time_s(), 0.25);
  clock.advance(1.0);
  EXPECT_EQ(clock.time_s(), 0.75);
}

TEST(playback_clock, clamp_holds_the_end_and_turns_back_at_once) {
  PlaybackClock clock(1.0, PlayMode::clamp);
  clock.advance(50.0);
  EXPECT_EQ(clock.time_s(), 1.0);
  EXPECT_FALSE(clock.finished());
  clock.set_speed(-1.0);
  clock.advance(0.25);
  EXPECT_EQ(clock.time_s(), 0.75);
  clock.advance(50.0);
  EXPECT_EQ(clock.time_s(), 0.0);
}

TEST(playback_clock, once_finishes_exactly_at_the_end_until_it_is_sought_or_turned) {
  PlaybackClock clock(1.0, PlayMode::once);
  clock.advance(0.5);
  EXPECT_FALSE(clock.finished());
  clock.advance(0.5);
  EXPECT_TRUE(clock.finished());
  EXPECT_EQ(clock.time_s(), 1.0);
  clock.advance(0.0);
  EXPECT_TRUE(clock.finished());
  clock.set_speed(-1.0);
  clock.advance(0.25);
  EXPECT_FALSE(clock.finished());
  EXPECT_EQ(clock.time_s(), 0.75);
  clock.advance(5.0);
  EXPECT_TRUE(clock.finished());
  clock.seek(0.5);
  EXPECT_FALSE(clock.finished());
}

TEST(playback_clock, seek_clamps_to_the_clip_and_can_stand_on_its_end) {
  PlaybackClock clock(2.0);
  clock.advance(5.0);
  clock.seek(9.0);
  EXPECT_EQ(clock.time_s(), 2.0);
  EXPECT_EQ(clock.rounds(), 0);
  clock.advance(0.5);
  EXPECT_EQ(clock.time_s(), 0.5);
  EXPECT_EQ(clock.rounds(), 1);
  clock.seek(-1.0);
  EXPECT_EQ(clock.time_s(), 0.0);
}

/// 0.7 and 0.1 leave a positive rest of rounding. Played back, it would keep the clock from reaching 0.
TEST(playback_clock, seeks_and_ends_forget_what_rounding_left) {
  PlaybackClock sought(1.0), stopped(1.0, PlayMode::once);
  for (PlaybackClock* clock : {&sought, &stopped})
    for (const double dt_s : {0.7, 0.1}) clock->advance(dt_s);
  sought.seek(0.5);
  sought.set_speed(-1.0);
  sought.advance(0.5);
  EXPECT_EQ(sought.time_s(), 0.0);
  stopped.advance(5.0);
  stopped.set_speed(-1.0);
  stopped.advance(1.0);
  EXPECT_EQ(stopped.time_s(), 0.0);
  EXPECT_TRUE(stopped.finished());
}

TEST(playback_clock, a_clip_without_length_stands_still) {
  for (const PlayMode mode : {PlayMode::loop, PlayMode::clamp, PlayMode::ping_pong, PlayMode::once}) {
    PlaybackClock clock(0.0, mode);
    clock.advance(12345.678);
    EXPECT_EQ(clock.time_s(), 0.0);
    EXPECT_EQ(clock.finished(), mode == PlayMode::once);
  }
}

TEST(playback_clock, a_number_that_is_none_is_answered_with_a_code_and_changes_nothing) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();
  for (const PlayMode mode : {PlayMode::loop, PlayMode::clamp, PlayMode::ping_pong, PlayMode::once}) {
    PlaybackClock clock(1.0, mode, 2.0);
    clock.advance(0.125);
    for (const double bad : {kNan, kInfinity, -kInfinity, 1e308, -1e308}) {
      const PlaybackStep step = clock.advance(bad);
      EXPECT_EQ(step.error, ErrorCode::not_finite) << bad;
      EXPECT_EQ(step.from_s, step.to_s);
      EXPECT_EQ(clock.set_speed(bad), ErrorCode::not_finite) << bad;
    }
    for (const double bad : {kNan, kInfinity, -kInfinity}) EXPECT_EQ(clock.seek(bad), ErrorCode::not_finite) << bad;
    EXPECT_EQ(clock.speed(), 2.0);
    EXPECT_EQ(clock.time_s(), 0.25);
    const PlaybackStep good = clock.advance(0.125);
    EXPECT_EQ(good.error, ErrorCode::ok);
    EXPECT_EQ(good.from_s, 0.25);
    EXPECT_EQ(clock.time_s(), 0.5);
  }
}

TEST(playback_clock, a_step_too_large_for_the_speed_is_refused_too) {
  PlaybackClock clock(1.0, PlayMode::loop, 1e200);
  EXPECT_EQ(clock.advance(1e150).error, ErrorCode::not_finite);
  clock.set_speed(0.0);
  EXPECT_EQ(clock.advance(std::numeric_limits<double>::infinity()).error, ErrorCode::not_finite);
  EXPECT_EQ(clock.time_s(), 0.0);
}

TEST(playback_clock, the_largest_steps_leave_a_time_of_the_clip) {
  for (const PlayMode mode : {PlayMode::loop, PlayMode::clamp, PlayMode::ping_pong, PlayMode::once})
    for (const double duration_s : {1e-30, 1.0, 1e30, PlaybackClock::kMost})
      for (const double sign : {1.0, -1.0}) {
        PlaybackClock clock(duration_s, mode);
        for (int frame = 0; frame < 5; ++frame) {
          const PlaybackStep step = clock.advance(sign * PlaybackClock::kMost);
          EXPECT_EQ(step.error, ErrorCode::ok);
          EXPECT_LE(std::fabs(step.to_turns), PlaybackClock::kMost) << "turns of a short clip end there";
          EXPECT_TRUE(clock.time_s() >= 0.0 && clock.time_s() <= duration_s) << duration_s;
          EXPECT_GE(sign * static_cast<double>(clock.rounds()), 0.0);
        }
      }
}

TEST(playback_clock, make_answers_codes_where_the_constructor_breaks_a_contract) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();
  for (const double bad : {kNan, kInfinity, -kInfinity, 1e301}) {
    EXPECT_EQ(PlaybackClock::make(bad).error(), ErrorCode::not_finite);
    EXPECT_EQ(PlaybackClock::make(1.0, PlayMode::loop, bad).error(), ErrorCode::not_finite);
    EXPECT_DEATH(PlaybackClock{bad}, "contract broken");
  }
  const double most = PlaybackClock::kMost, above = std::nextafter(most, 2.0 * most);
  EXPECT_TRUE(PlaybackClock::make(most, PlayMode::loop, -most));
  EXPECT_EQ(PlaybackClock::make(above).error(), ErrorCode::not_finite);
  EXPECT_EQ(PlaybackClock::make(1.0, PlayMode::loop, -above).error(), ErrorCode::not_finite);
  EXPECT_EQ(PlaybackClock::make(-1.0).error(), ErrorCode::unsupported);
  EXPECT_EQ(PlaybackClock::make(2.0, PlayMode::once, 0.5)->duration_s(), 2.0);
}

// 24 h at 60 Hz. The truth is the exact sum of the steps: long double carries 2^-64 relative, here 5e-15 s.
TEST(playback_clock, N24_a_day_of_frames_does_not_drift) {
  for (const double speed : {1.0, -1.0, 0.37, 3.7}) {
    const double duration_s = 1.234567891;
    PlaybackClock clock(duration_s, PlayMode::loop, speed);
    const std::int64_t frames = 24LL * 3600 * 60;
    for (std::int64_t f = 0; f < frames; ++f) clock.advance(kFrame);
    const long double total_s =
        static_cast<long double>(frames) * static_cast<long double>(kFrame) * static_cast<long double>(speed);
    const long double played_s = static_cast<long double>(clock.rounds()) * static_cast<long double>(duration_s) +
                                 static_cast<long double>(clock.time_s());
    EXPECT_NEAR(static_cast<double>(played_s - total_s), 0.0, 1e-13) << speed;
  }
}

// Plain summation in double drifts by more than that, so the compensation is needed.
TEST(playback_clock, N24_plain_double_sums_do_drift) {
  double phase_s = 0.0;
  std::int64_t rounds = 0;
  const double duration_s = 1.234567891;
  const std::int64_t frames = 24LL * 3600 * 60;
  for (std::int64_t f = 0; f < frames; ++f) {
    phase_s += kFrame;
    if (phase_s >= duration_s) {
      phase_s -= duration_s;
      ++rounds;
    }
  }
  const long double played_s =
      static_cast<long double>(rounds) * static_cast<long double>(duration_s) + static_cast<long double>(phase_s);
  EXPECT_GT(
      std::fabs(static_cast<double>(played_s - static_cast<long double>(frames) * static_cast<long double>(kFrame))),
      1e-11);
}

TEST(playback_clock, G12_sixty_frames_of_a_sixtieth_meet_the_seam_of_a_second_each_time) {
  PlaybackClock clock(1.0);
  for (int second = 1; second <= 36000; ++second) {
    for (int f = 0; f < 60; ++f) clock.advance(kFrame);
    ASSERT_NEAR(clock.time_s() + static_cast<double>(clock.rounds()), second, 1e-12);
    ASSERT_LT(clock.time_s(), 1.0);
  }
}

TEST(playback_clock, N24_one_long_step_equals_many_short_ones) {
  PlaybackClock one(0.7, PlayMode::ping_pong), many(0.7, PlayMode::ping_pong);
  one.advance(3600.0);
  for (int i = 0; i < 3600 * 1024; ++i) many.advance(1.0 / 1024.0);
  EXPECT_NEAR(one.time_s(), many.time_s(), 1e-12);
  EXPECT_EQ(one.rounds(), many.rounds());
}

}  // namespace
}  // namespace sinew
