// SPDX-License-Identifier: MIT
#include "runtime/graph/play_motions.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <tuple>

#include "runtime/graph/whole_division.h"

namespace sinew {
namespace {

constexpr std::int64_t kMostRoundsOfEvents = 1024;

/// One motion in one piece of a step. When time runs backwards, positions are negated, so that they always increase.
class Passage {
 public:
  Passage(LiveGraph& live, const LiveMotion& motion, GraphTicks ticks, GraphEventLog& log) noexcept
      : live_(live), motion_(motion), log_(log), ticks_(std::abs(ticks)), clock_(ticks < 0 ? -1 : 1) {
    const std::int64_t step = motion.step * clock_;
    sign_ = step < 0 ? -1 : 1;
    step_ = step * sign_;
    from_ = motion.state->position * sign_;
    to_ = from_ + step_ * ticks_;
    has_started_ = motion.state->started != 0;
    first_ = has_started_ ? from_ + 1 : from_;
  }

  std::int64_t end() const noexcept { return to_ * sign_; }

  void tell_events(const LiveSample& sample) noexcept {
    const GraphClipSet::Entry& entry = *sample.entry;
    if (entry.event_count == 0 || entry.period == 0) return;
    if (motion_.segments > 0) {
      for (const SpaceEvent& event : live_.clips().space_beats().events(sample.point))
        tell(sample, event.index, event.position);
      return;
    }
    const auto events = live_.clips().events_of(entry);
    for (std::size_t e = 0; e < events.size(); ++e)
      tell(sample, static_cast<std::uint32_t>(e), place_of(events[e], entry));
  }

 private:
  std::int64_t place_of(std::int64_t event, const GraphClipSet::Entry& entry) const noexcept {
    if (!motion_.is_space) return event;
    return nearest_whole(static_cast<double>(event) / static_cast<double>(entry.period) *
                         static_cast<double>(kPhasePeriod));
  }

  void tell(const LiveSample& sample, std::uint32_t event, std::int64_t place) noexcept {
    const std::int64_t period = motion_.period, mirrored = place * sign_;
    if (!motion_.loop) {
      if (mirrored >= first_ && mirrored <= to_) add(sample, event, mirrored);
      return;
    }
    if (has_started_ && first_pass(mirrored) > to_) return;
    std::int64_t round = divided_up(first_ - mirrored, period);
    // A motion that starts at 0 does not report events at the end of the previous round.
    if (!has_started_ && mirrored + round * period == from_ && place == period && sign_ > 0) ++round;
    std::int64_t last = divided_down(to_ - mirrored, period);
    if (last - round >= kMostRoundsOfEvents) {
      log_.leave_out(static_cast<std::uint64_t>(last - round + 1 - kMostRoundsOfEvents));
      last = round + kMostRoundsOfEvents - 1;
    }
    for (; round <= last && !log_.is_full(); ++round) add(sample, event, mirrored + round * period);
    if (round <= last) log_.leave_out(static_cast<std::uint64_t>(last - round + 1));
  }

  /// The first position of an event that a motion which has started may report. It is found without a division, since
  /// the motion lies within its first period.
  std::int64_t first_pass(std::int64_t mirrored) const noexcept {
    while (mirrored < first_) mirrored += motion_.period;
    return mirrored;
  }

  void add(const LiveSample& sample, std::uint32_t event, std::int64_t place) noexcept {
    const GraphTicks in = divided_up(place - from_, step_);
    if (in != weighed_at_) {
      live_.weigh(clock_ > 0 ? in : 0);
      weighed_at_ = in;
    }
    log_.add({.at = live_.header().now + clock_ * in,
              .node = motion_.node,
              .clip = sample.name,
              .index = event,
              .weight = motion_.weight * sample.share});
  }

  LiveGraph& live_;
  const LiveMotion& motion_;
  GraphEventLog& log_;
  GraphTicks ticks_;
  std::int64_t clock_, sign_ = 1, step_ = 0, from_ = 0, to_ = 0;
  std::int64_t first_ = 0;  ///< first position whose events count
  bool has_started_ = false;
  GraphTicks weighed_at_ = -1;
};

void move(LiveMotion& motion, std::int64_t end) noexcept {
  MotionState& state = *motion.state;
  state.started = 1;
  if (!motion.loop) {
    state.position = std::clamp(end, std::int64_t{0}, motion.period);
    return;
  }
  const std::int64_t rounds = divided_down(end, motion.period);
  state.position = end - rounds * motion.period;
  constexpr std::int64_t kMost = std::numeric_limits<std::int32_t>::max();
  state.rounds = static_cast<std::int32_t>(std::clamp(state.rounds + rounds, -kMost, kMost));
}

}  // namespace

void GraphEventLog::sort_from(std::size_t first, bool backwards) noexcept {
  const auto key = [backwards](const GraphEvent& e) {
    return std::tuple(backwards ? -e.at : e.at, e.node, e.clip, e.index);
  };
  std::sort(room_.begin() + static_cast<std::ptrdiff_t>(first), room_.begin() + step_.event_count,
            [&](const GraphEvent& a, const GraphEvent& b) { return key(a) < key(b); });
}

void play_motions(LiveGraph& live, GraphTicks ticks, GraphEventLog& log) noexcept {
  const std::size_t first = log.count();
  for (LiveMotion& motion : live.motions()) {
    if (motion.period == 0 || motion.step == 0) continue;
    Passage passage(live, motion, ticks, log);
    for (const LiveSample& sample : live.samples_of(motion)) passage.tell_events(sample);
    move(motion, passage.end());
  }
  if (log.count() > first + 1) log.sort_from(first, ticks < 0);
}

GraphTicks longest_piece(LiveGraph& live, GraphTicks most, bool backwards) noexcept {
  constexpr std::int64_t kFarthest = std::int64_t{1} << 61;
  for (const LiveMotion& motion : live.motions()) {
    if (motion.step == 0) continue;
    const std::int64_t step = std::abs(motion.step);
    // Divisions take long, so they are only made where a limit is near.
    if (static_cast<double>(step) * static_cast<double>(most) > 0.5 * static_cast<double>(kFarthest))
      most = std::min(most, kFarthest / step);
    const std::int64_t way = motion.to_segment_end(backwards);
    if (way < step * most) most = divided_up(way, step);
  }
  return most;
}

}  // namespace sinew
