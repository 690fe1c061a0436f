// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "runtime/base/api.h"
#include "runtime/playback/playback_clock.h"

namespace sinew {

/// Iterates over the events that a step of a clock crosses, in the order of play, once per crossing:
///     for (EventCursor crossed(clock.advance(dt), times); auto i = crossed.next();) fire(*i);
///
/// Each crossing belongs to exactly one step. A step includes the time where it ends but not the time where it starts;
/// the first step after a start or seek includes both. In a loop, events at the end and at 0 are both crossed at the
/// seam. In ping-pong, an event at either end is crossed once per turn, others once in each direction.
///
/// The work is bounded for any clip and step. In a step of more than kMostRounds rounds, the cursor visits the first
/// round and the last kMostRounds - 1. It skips the rounds_left_out() rounds between, each of which crosses every
/// event once (in ping-pong, events between the ends twice).
/// in   event_times_s[E]  never decreasing, in [0, duration]; must outlive the cursor
/// cost O(E) per visited round, no allocation
class SINEW_API EventCursor {
 public:
  /// Most rounds that are visited in one step.
  static constexpr std::uint64_t kMostRounds = 1024;

  EventCursor(const PlaybackStep& step, std::span<const double> event_times_s) noexcept;

  /// Index of the next crossed event; nullopt if there is none.
  std::optional<std::size_t> next() noexcept;

  /// Clip time from the start of the step to the event that next() returned last, in seconds, >= 0.
  double played_s() const noexcept { return played_s_; }

  /// Number of whole rounds whose events next() skips; at most 2^63.
  std::uint64_t rounds_left_out() const noexcept { return rounds_left_out_; }

 private:
  struct Stop {
    std::size_t event;
    double phase_s;
    bool real;
  };
  Stop stop_at(std::size_t slot) const noexcept;
  bool crosses(const Stop& stop) const noexcept;
  double played_until(const Stop& stop) const noexcept;

  PlaybackStep step_;
  std::span<const double> times_s_;
  bool forward_ = true;
  std::size_t slots_ = 0, slot_ = 0;  // number of stops in one round, and the next one to look at
  std::size_t first_on_seam_ = 0;     // events from here on lie at the last key's time
  // Visited rounds; the step begins in round 0 and ends in the last one.
  std::uint64_t round_ = 0, round_count_ = 0;
  std::uint64_t rounds_left_out_ = 0;
  double played_s_ = 0.0;
};

}  // namespace sinew
