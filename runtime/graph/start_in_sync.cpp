// SPDX-License-Identifier: MIT
#include "runtime/graph/start_in_sync.h"

#include <algorithm>
#include <cmath>

#include "runtime/sync/floor_division.h"

namespace sinew {
namespace {

/// The beats of a motion. The length of a motion that stands still is any length.
SyncTrack track_of(const LiveGraph& live, const LiveMotion& motion) noexcept {
  const double length_s = motion.length > 0.0 ? motion.length / static_cast<double>(kTicksPerSecond) : 1.0;
  if (!motion.is_space) {
    const LiveSample& sample = live.samples_of(motion)[0];
    return live.clips().track_of(*sample.entry, sample.mirror, length_s);
  }
  SyncTrack track = live.clips().space_beats().track(live.tables().nodes[motion.node].settings);
  track.length_s = length_s;
  return track;
}

/// The place of a motion that plays in the other direction.
CyclePlace reversed(const CyclePlace& place) noexcept { return {place.round, below_1(1.0 - place.phase)}; }

}  // namespace

SyncSource find_sync_source(const LiveGraph& live, GraphIndex node, std::byte* base) noexcept {
  LiveGraph only(live.graph(), live.clips(), live.parameters(), live.state());
  const std::uint16_t main = only.open_only(node, base);
  if (main == kNoMotion) return {};
  const LiveMotion& motion = only.motions()[main];
  if (motion.period == 0) return {};
  const double phase = static_cast<double>(motion.state->position) / static_cast<double>(motion.period);
  return {track_of(only, motion), {0, phase}, true, motion.own_step < 0};
}

void start_in_sync(const LiveGraph& live, GraphIndex node, std::byte* base, const SyncSource& source,
                   SyncStart rule) noexcept {
  if (!source.moves) return;
  LiveGraph only(live.graph(), live.clips(), live.parameters(), live.state());
  const std::uint16_t main = only.open_only(node, base);
  if (main == kNoMotion || only.motions()[main].period == 0) return;
  const LiveMotion& motion = only.motions()[main];
  const bool by_time = rule == SyncStart::time_left;
  CyclePlace place = source.place;
  if (by_time && source.backwards) place = reversed(place);
  // A clip that does not loop may stand at its end, which is no place in a cycle.
  place.phase = rule == SyncStart::phase ? place.phase : below_1(place.phase);
  place = start_place(source.track, place, track_of(only, motion), rule);
  if (by_time && motion.own_step < 0) place = reversed(place);
  const auto position = std::llround(place.phase * static_cast<double>(motion.period));
  motion.state->position = std::min<std::int64_t>(position, motion.period - 1);
  motion.state->started = 1;
}

}  // namespace sinew
