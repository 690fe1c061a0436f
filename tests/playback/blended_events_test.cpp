// SPDX-License-Identifier: MIT
#include "runtime/playback/blended_events.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <tuple>
#include <vector>

namespace sinew {
namespace {

/// A crossing: its moment, clip, event and weight.
using Crossing = std::tuple<double, std::size_t, std::size_t, float>;

std::vector<Crossing> crossed(const std::vector<PlayingClip>& playing) {
  std::vector<BlendedEvents::Cursor> cursors(playing.size());
  std::vector<Crossing> seen;
  for (BlendedEvents events(playing, cursors); const auto e = events.next();)
    seen.emplace_back(e->moment, e->clip, e->event, e->weight);
  return seen;
}

float weight_at(const PlayingClip& clip, double moment) {
  const double before = static_cast<double>(clip.weight_before), after = static_cast<double>(clip.weight_after);
  return static_cast<float>((1.0 - moment) * before + moment * after);
}

/// The truth: each event of a looping clip lies at every time_s + k duration_s of a line without end. A step crosses
/// those after its start, up to its end.
void add_truth(std::vector<Crossing>& to, std::size_t c, const PlayingClip& clip, double from_s, bool fresh) {
  const double to_s = from_s + clip.step_s, duration_s = clip.step.duration_s;
  const double low = std::min(from_s, to_s), high = std::max(from_s, to_s);
  for (std::size_t e = 0; e < clip.event_times_s.size(); ++e)
    for (double k = std::floor(low / duration_s) - 2; k <= high / duration_s + 2; ++k) {
      const double at = clip.event_times_s[e] + k * duration_s;
      const bool inside = clip.step_s >= 0.0 ? from_s < at && at <= to_s : to_s <= at && at < from_s;
      if (!inside && !(fresh && at == from_s && k == 0)) continue;
      const double moment = clip.step_s != 0.0 ? std::fabs(at - from_s) / std::fabs(clip.step_s) : 1.0;
      to.emplace_back(moment, c, e, weight_at(clip, moment));
    }
}

TEST(blended_events, every_event_comes_once_with_its_weight_in_steps_of_any_length) {
  std::mt19937 random(5);
  const auto below = [&](std::uint32_t count) { return static_cast<double>(random() % count); };
  // All times are multiples of 1/64 s, so sums are exact.
  const std::array<std::vector<double>, 3> events{{{0.25, 0.5, 0.5}, {0.125}, {}}};
  const std::array<double, 3> durations{1.0, 0.75, 0.5};
  for (int round = 0; round < 200; ++round) {
    std::vector<PlaybackClock> clocks;
    std::vector<double> line_s(3, 0.0);
    std::vector<float> weights(3, 0.0f);
    for (std::size_t c = 0; c < 3; ++c) clocks.emplace_back(durations[c], PlayMode::loop, c == 1 ? 2.0 : 1.0);
    for (int step = 0; step < 12; ++step) {
      const double dt_s = step % 4 == 0 ? 0.0 : step % 7 == 6 ? 10.0 : (below(96) - 32.0) / 64.0;
      std::vector<PlayingClip> playing;
      std::vector<Crossing> truth;
      for (std::size_t c = 0; c < 3; ++c) {
        const float after = static_cast<float>(below(5)) / 4.0f;
        playing.push_back({.step = clocks[c].advance(dt_s),
                           .event_times_s = events[c],
                           .step_s = clocks[c].speed() * dt_s,
                           .weight_before = weights[c],
                           .weight_after = after});
        if (weights[c] != 0.0f || after != 0.0f) add_truth(truth, c, playing[c], line_s[c], step == 0);
        line_s[c] += playing[c].step_s;
        weights[c] = after;
      }
      std::vector<Crossing> seen = crossed(playing);
      EXPECT_TRUE(
          std::is_sorted(seen.begin(), seen.end(), [](auto& a, auto& b) { return std::get<0>(a) < std::get<0>(b); }));
      std::sort(seen.begin(), seen.end());
      std::sort(truth.begin(), truth.end());
      EXPECT_EQ(seen, truth) << "round " << round << " step " << step << " of " << dt_s;
    }
  }
}

TEST(blended_events, a_clip_that_a_fade_ends_still_reports_its_last_step) {
  PlaybackClock out(1.0), in(1.0);
  const std::vector<double> times{0.25, 0.75};
  EXPECT_EQ(crossed({{out.advance(0.5), times, 0.5, 1.0f, 0.0f}, {in.advance(0.5), times, 0.5, 0.0f, 1.0f}}),
            (std::vector<Crossing>{{0.5, 0, 0, 0.5f}, {0.5, 1, 0, 0.5f}}));
  EXPECT_EQ(crossed({{out.advance(0.5), times, 0.5, 0.0f, 0.0f}}), std::vector<Crossing>{}) << "it plays no more";
}

TEST(blended_events, clips_that_stop_or_turn_have_moments_of_the_whole_step) {
  PlaybackClock once(1.0, PlayMode::once), turns(1.0, PlayMode::ping_pong, -2.0);
  const std::vector<double> times{0.5, 1.0};
  EXPECT_EQ(crossed({{once.advance(10.0), times, 10.0, 0.0f, 1.0f}}),
            (std::vector<Crossing>{{0.05, 0, 0, 0.05f}, {0.1, 0, 1, 0.1f}}));
  // Backwards from 0, a ping-pong comes from the way back: 0.5 after a quarter second, the end after half of one.
  EXPECT_EQ(crossed({{turns.advance(0.5), times, -1.0, 1.0f, 1.0f}}),
            (std::vector<Crossing>{{0.5, 0, 0, 1.0f}, {1.0, 0, 1, 1.0f}}));
}

TEST(blended_events, the_work_is_bounded_and_bad_steps_have_no_events) {
  PlaybackClock fast(0.001), bad(1.0);
  const std::vector<double> times{0.0005};
  std::vector<PlayingClip> playing{{fast.advance(10.0), times, 10.0, 1.0f, 1.0f},
                                   {bad.advance(std::nan("")), times, 1.0, 1.0f, 1.0f}};
  std::vector<BlendedEvents::Cursor> cursors(2);
  BlendedEvents events(playing, cursors);
  std::size_t count = 0;
  double last = 0.0;
  while (const auto e = events.next()) {
    EXPECT_EQ(e->clip, 0u);
    EXPECT_GE(e->moment, last);
    last = e->moment;
    ++count;
  }
  EXPECT_GT(last, 0.999);
  EXPECT_LE(count, EventCursor::kMostRounds);
  EXPECT_EQ(count + events.rounds_left_out(), 10000u);
}

}  // namespace
}  // namespace sinew
