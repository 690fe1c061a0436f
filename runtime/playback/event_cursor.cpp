// SPDX-License-Identifier: MIT
#include "runtime/playback/event_cursor.h"

#include <algorithm>
#include <cmath>

namespace sinew {
namespace {

bool before(double turn_a, double phase_a, double turn_b, double phase_b) noexcept {
  return turn_a < turn_b || (turn_a == turn_b && phase_a < phase_b);
}

}  // namespace

EventCursor::EventCursor(const PlaybackStep& step, std::span<const double> event_times_s) noexcept
    : step_(step), times_s_(event_times_s), turn_(step.from_turns) {
  forward_ = !before(step.to_turns, step.to_s, step.from_turns, step.from_s);
  slots_ = step.mode == PlayMode::ping_pong ? 2 * times_s_.size() : times_s_.size();
  first_on_seam_ =
      static_cast<std::size_t>(std::lower_bound(times_s_.begin(), times_s_.end(), step.duration_s) - times_s_.begin());
  constexpr double kMostRounds = 9.0e15;
  const double rounds = std::fabs(step.to_turns - step.from_turns) + 1.0;  // both ends included
  rounds_left_ = slots_ == 0 ? 0 : static_cast<std::uint64_t>(std::min(rounds, kMostRounds));
}

std::optional<std::size_t> EventCursor::next() noexcept {
  while (rounds_left_ > 0) {
    while (slot_ < slots_) {
      const Stop stop = stop_at(forward_ ? slot_ : slots_ - 1 - slot_);
      ++slot_;
      if (stop.real && crosses(stop)) return stop.event;
    }
    slot_ = 0;
    --rounds_left_;
    turn_ += forward_ ? 1.0 : -1.0;
  }
  return std::nullopt;
}

EventCursor::Stop EventCursor::stop_at(std::size_t slot) const noexcept {
  const std::size_t count = times_s_.size();
  const double end_s = step_.duration_s;
  if (step_.mode == PlayMode::loop && end_s > 0.0) {
    // The seam is phase 0 of the next round: the events of the end come first, then those of the start.
    const std::size_t event = (slot + first_on_seam_) % count;
    return {event, event >= first_on_seam_ ? 0.0 : times_s_[event], true};
  }
  if (slot < count) return {slot, times_s_[slot], true};
  const std::size_t event = 2 * count - 1 - slot;
  const double time_s = times_s_[event];
  return {event, 2.0 * end_s - time_s, time_s > 0.0 && time_s < end_s};
}

bool EventCursor::crosses(const Stop& stop) const noexcept {
  const bool at_start = turn_ == step_.from_turns && stop.phase_s == step_.from_s;
  if (at_start) return step_.from_included && times_s_[stop.event] == stop.phase_s;
  return forward_ ? before(step_.from_turns, step_.from_s, turn_, stop.phase_s) &&
                        !before(step_.to_turns, step_.to_s, turn_, stop.phase_s)
                  : before(turn_, stop.phase_s, step_.from_turns, step_.from_s) &&
                        !before(turn_, stop.phase_s, step_.to_turns, step_.to_s);
}

}  // namespace sinew
