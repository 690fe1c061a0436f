// SPDX-License-Identifier: MIT
#include "runtime/graph/space_beats.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "runtime/graph/state_blocks.h"
#include "runtime/sync/common_beats.h"
#include "runtime/sync/sync_group.h"

namespace sinew {
namespace {

/// Members of a space that have beats, and the beats of each that are kept.
struct Group {
  std::vector<SyncMember> members;
  std::vector<std::vector<SyncBeat>> kept;

  bool names_agree(std::uint32_t segments) const {
    for (std::uint32_t k = 0; k < segments; ++k)
      for (const SyncMember& m : members)
        if (name_of_beat(m.track, std::int64_t{k} + m.first_beat) != name_of_beat(members[0].track, k)) return false;
    return true;
  }

  /// Leaves only the beats that all members share in the same order.     out  false: they share none
  bool keep_common_beats() {
    std::vector<SyncTrack> tracks;
    for (const SyncMember& m : members) tracks.push_back(m.track);
    std::vector<std::uint32_t> bits(members.size());
    if (find_common_beats(tracks, bits) == 0) return false;
    kept.resize(members.size());
    for (std::size_t m = 0; m < members.size(); ++m) {
      for (std::size_t b = 0; b < tracks[m].beats.size(); ++b)
        if ((bits[m] >> b & 1u) != 0) kept[m].push_back(tracks[m].beats[b]);
      members[m].track.beats = kept[m];
    }
    align_names(members);
    return true;
  }
};

}  // namespace

Result<SpaceBeats> SpaceBeats::make(const GraphTables& tables, std::span<const SpaceClip> clips) {
  SpaceBeats made;
  made.points_.resize(tables.points.size());
  for (const GraphBlendSpace& space : tables.spaces)
    if (const ErrorCode code = made.add_space(space, clips); code != ErrorCode::ok) return tl::make_unexpected(code);
  return made;
}

ErrorCode SpaceBeats::add_space(const GraphBlendSpace& space, std::span<const SpaceClip> clips) {
  const std::size_t first = space.first_point, count = space.point_count;
  Group group;
  std::vector<std::size_t> member_of(count, count);
  for (std::size_t i = 0; i < count; ++i)
    if (!clips[first + i].track.beats.empty()) {
      member_of[i] = group.members.size();
      group.members.push_back({.track = clips[first + i].track});
    }
  Space& made = spaces_.emplace_back();
  if (group.members.empty()) return ErrorCode::ok;
  align_names(group.members);
  std::uint32_t segments = common_segments(group.members);
  if (segments == 0 || !group.names_agree(segments)) {
    if (!group.keep_common_beats()) return ErrorCode::ok;
    segments = common_segments(group.members);
  }
  if (segments > kMostGraphSegments) return ErrorCode::too_large;
  made.segments = segments;
  made.first_beat = static_cast<std::uint32_t>(beats_.size());
  for (std::uint32_t k = 0; k < segments; ++k)
    beats_.push_back({static_cast<double>(k) / segments, name_of_beat(group.members[0].track, k)});
  for (std::size_t i = 0; i < count; ++i) {
    std::array<double, kMostGraphSegments + 1> bounds;
    for (std::uint32_t k = 0; k <= segments; ++k) {
      bounds[k] = static_cast<double>(k) / segments;
      if (member_of[i] == count) continue;
      const SyncMember& member = group.members[member_of[i]];
      const CyclePlace place = cycle_place(member, BeatPlace{k, 0.0});
      bounds[k] = static_cast<double>(place.round) + place.phase;
    }
    add_point(first + i, clips[first + i], std::span(bounds).first(segments + 1));
  }
  return ErrorCode::ok;
}

void SpaceBeats::add_point(std::size_t point, const SpaceClip& clip, std::span<const double> bounds) {
  Point& made = points_[point];
  made.first_bound = static_cast<std::uint32_t>(bounds_.size());
  made.first_event = static_cast<std::uint32_t>(events_.size());
  bounds_.insert(bounds_.end(), bounds.begin(), bounds.end());
  const std::size_t segments = bounds.size() - 1;
  made.rounds = std::round(bounds.back() - bounds.front());
  for (std::uint32_t e = 0; e < clip.event_phases.size(); ++e) {
    // The event's first time at or after the start of the common cycle.
    double phase = clip.event_phases[e] + std::ceil(bounds.front() - clip.event_phases[e]);
    for (double round = 0.0; round < made.rounds; ++round, phase += 1.0) {
      std::size_t k = 0;
      while (k + 1 < segments && bounds[k + 1] <= phase) ++k;
      const double share = std::clamp((phase - bounds[k]) / (bounds[k + 1] - bounds[k]), 0.0, 1.0);
      const double place = (static_cast<double>(k) + share) / static_cast<double>(segments);
      events_.push_back({std::llround(place * static_cast<double>(kPhasePeriod)) % kPhasePeriod, e});
    }
  }
  made.event_count = static_cast<std::uint32_t>(events_.size()) - made.first_event;
}

}  // namespace sinew
