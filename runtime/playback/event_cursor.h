// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "runtime/playback/playback_clock.h"

namespace sinew {

/// Goes through the events that a step of a clock crosses, in the order of play, once per crossing:
///     for (EventCursor crossed(clock.advance(dt), times); auto i = crossed.next();) fire(*i);
///
/// Every crossing belongs to exactly one step: a step owns the place where it ends, not the one where it starts (the
/// first step after a start or seek owns both). When looping, events at the last key's time and at 0 share the
/// seam, and both are crossed there; ping-pong crosses an event at either end once per turn and others once each way.
///
/// Work is bounded, however short the clip and long the step: of a step that touches more than kMostRounds rounds the
/// cursor goes through the first one and the last kMostRounds - 1. The rounds between are counted, not told:
/// rounds_left_out() of them crossed every event once (in ping-pong the events between the ends twice).
/// in   event_times_s[E]  rising, in [0, duration]; must outlive the cursor
/// cost O(E) per round that is gone through, no allocation
class EventCursor {
 public:
  /// Rounds of one step that are gone through event by event.
  static constexpr std::uint64_t kMostRounds = 1024;

  EventCursor(const PlaybackStep& step, std::span<const double> event_times_s) noexcept;

  /// Index of the next event crossed, nothing when there is none left.
  std::optional<std::size_t> next() noexcept;

  /// Whole rounds whose crossings next() leaves out; at most 2^63.
  std::uint64_t rounds_left_out() const noexcept { return rounds_left_out_; }

 private:
  struct Stop {
    std::size_t event;
    double phase_s;
    bool real;
  };
  Stop stop_at(std::size_t slot) const noexcept;
  bool crosses(const Stop& stop) const noexcept;

  PlaybackStep step_;
  std::span<const double> times_s_;
  bool forward_ = true;
  std::size_t slots_ = 0, slot_ = 0;  // stops of one round, in the order of forward play
  std::size_t first_on_seam_ = 0;     // events from here on lie at the last key's time
  // Rounds that are gone through: the step begins in round 0 and ends in the last one.
  std::uint64_t round_ = 0, round_count_ = 0;
  std::uint64_t rounds_left_out_ = 0;
};

}  // namespace sinew
