// SPDX-License-Identifier: MIT
#include "runtime/playback/event_cursor.h"

#include <algorithm>
#include <cmath>

namespace sinew {
namespace {

/// A number of rounds as an integer, at most 2^63. NaN, which no clock returns, becomes 0.
std::uint64_t whole(double rounds) noexcept {
  constexpr double kMost = 0x1p63;
  return rounds > 0.0 ? static_cast<std::uint64_t>(std::min(rounds, kMost)) : 0;
}

}  // namespace

EventCursor::EventCursor(const PlaybackStep& step, std::span<const double> event_times_s) noexcept
    : step_(step), times_s_(event_times_s) {
  forward_ = step.to_turns > step.from_turns || (step.to_turns == step.from_turns && !(step.to_s < step.from_s));
  slots_ = step.mode == PlayMode::ping_pong ? 2 * times_s_.size() : times_s_.size();
  first_on_seam_ =
      static_cast<std::size_t>(std::lower_bound(times_s_.begin(), times_s_.end(), step.duration_s) - times_s_.begin());
  const std::uint64_t touched =
      whole(std::fabs(step.to_turns - step.from_turns)) + 1;  // including the first and the last
  round_count_ = std::min(touched, kMostRounds);
  rounds_left_out_ = touched - round_count_;
}

std::optional<std::size_t> EventCursor::next() noexcept {
  for (; round_ < round_count_; ++round_) {
    while (slot_ < slots_) {
      const Stop stop = stop_at(forward_ ? slot_ : slots_ - 1 - slot_);
      ++slot_;
      if (!stop.real || !crosses(stop)) continue;
      played_s_ = played_until(stop);
      return stop.event;
    }
    slot_ = 0;
  }
  return std::nullopt;
}

EventCursor::Stop EventCursor::stop_at(std::size_t slot) const noexcept {
  const std::size_t count = times_s_.size();
  const double end_s = step_.duration_s;
  if (step_.mode == PlayMode::loop && end_s > 0.0) {
    // The seam is phase 0 of the next round. There the events at the end of the clip come first, then those at time 0.
    const std::size_t event = (slot + first_on_seam_) % count;
    return {event, event >= first_on_seam_ ? 0.0 : times_s_[event], true};
  }
  if (slot < count) return {slot, times_s_[slot], true};
  const std::size_t event = 2 * count - 1 - slot;
  const double time_s = times_s_[event];
  return {event, 2.0 * end_s - time_s, time_s > 0.0 && time_s < end_s};
}

bool EventCursor::crosses(const Stop& stop) const noexcept {
  const bool is_first = round_ == 0, is_last = round_ + 1 == round_count_;
  if (is_first && stop.phase_s == step_.from_s) return step_.from_included && times_s_[stop.event] == stop.phase_s;
  const double phase_s = stop.phase_s;
  const bool has_begun = !is_first || (forward_ ? step_.from_s < phase_s : phase_s < step_.from_s);
  const bool has_ended = is_last && (forward_ ? step_.to_s < phase_s : phase_s < step_.to_s);
  return has_begun && !has_ended;
}

double EventCursor::played_until(const Stop& stop) const noexcept {
  const std::uint64_t left_out = round_ == 0 ? 0 : rounds_left_out_;
  const double period_s = step_.mode == PlayMode::ping_pong ? 2.0 * step_.duration_s : step_.duration_s;
  const double in_round_s = forward_ ? stop.phase_s - step_.from_s : step_.from_s - stop.phase_s;
  return in_round_s + static_cast<double>(round_ + left_out) * period_s;
}

}  // namespace sinew
