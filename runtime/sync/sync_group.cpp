// SPDX-License-Identifier: MIT
#include "runtime/sync/sync_group.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "runtime/sync/floor_division.h"

namespace sinew {
namespace {

double total_weight(SyncGroup group) noexcept {
  double total = 0.0;
  for (const SyncMember& member : group) total += member.weight;
  return total;
}

/// eq   the weighted mean of `value(member)`
template <class Value>
double mean(SyncGroup group, const Value& value) noexcept {
  const double total = total_weight(group);
  double sum = 0.0;
  for (const SyncMember& member : group) sum += (total > 0.0 ? member.weight : 1.0) * value(member);
  return sum / (total > 0.0 ? total : static_cast<double>(group.size()));
}

double segment_length_s(SyncGroup group, std::int64_t segment) noexcept {
  return mean(group, [&](const SyncMember& member) {
    return member.track.length_s * beat_length(member.track, segment + member.first_beat);
  });
}

/// Number of segments of the common cycle in which both members have beats of the same name.
std::uint32_t equal_names(const SyncTrack& a, const SyncMember& b, std::uint32_t segments) noexcept {
  std::uint32_t count = 0;
  for (std::uint32_t k = 0; k < segments; ++k)
    count += name_of_beat(a, k) == name_of_beat(b.track, std::int64_t{k} + b.first_beat) ? 1 : 0;
  return count;
}

/// Index of the first beat with this name, or `otherwise` if there is none.
std::size_t beat_of_name(const SyncTrack& track, std::uint32_t name, std::size_t otherwise) noexcept {
  for (std::size_t k = 0; k < track.beats.size(); ++k)
    if (name_of_beat(track, static_cast<std::int64_t>(k)) == name) return k;
  return otherwise;
}

}  // namespace

ErrorCode check(SyncGroup group) noexcept {
  for (const SyncMember& member : group) {
    if (const ErrorCode error = check(member.track); error != ErrorCode::ok) return error;
    if (!std::isfinite(member.weight)) return ErrorCode::not_finite;
    if (member.weight < 0.0) return ErrorCode::negative_weight;
    if (member.first_beat >= beat_count(member.track)) return ErrorCode::index_out_of_range;
  }
  return common_segments(group) > 0 ? ErrorCode::ok : ErrorCode::too_large;
}

std::uint32_t common_segments(SyncGroup group) noexcept {
  std::uint64_t common = 1;
  for (const SyncMember& member : group) {
    const std::uint64_t beats = beat_count(member.track);
    common = common / std::gcd(common, beats) * beats;
    if (common > kMostSegments) return 0;
  }
  return static_cast<std::uint32_t>(common);
}

double common_length_s(SyncGroup group) noexcept {
  if (group.empty()) return 0.0;
  const double segments = common_segments(group);
  return mean(group, [&](const SyncMember& member) {
    return segments / static_cast<double>(beat_count(member.track)) * member.track.length_s;
  });
}

void align_names(std::span<SyncMember> group) noexcept {
  if (group.empty()) return;
  group[0].first_beat = 0;
  for (SyncMember& member : group.subspan(1)) {
    const SyncMember both[] = {group[0], member};
    const std::uint32_t segments = common_segments(both);
    std::uint32_t best = 0, most = 0;
    for (member.first_beat = 0; member.first_beat < beat_count(member.track); ++member.first_beat)
      if (const std::uint32_t equal = equal_names(group[0].track, member, segments); equal > most) {
        most = equal;
        best = member.first_beat;
      }
    member.first_beat = best;
  }
}

BeatPlace advance(SyncGroup group, const BeatPlace& place, double dt_s) noexcept {
  const double cycle_s = common_length_s(group);
  if (!(cycle_s > 0.0)) return place;
  constexpr double kMostRounds = 0x1p40;
  const double rounds = std::clamp(std::floor(dt_s / cycle_s), -kMostRounds, kMostRounds);
  BeatPlace at = place;
  const std::uint32_t segments = common_segments(group);
  at.beat += static_cast<std::int64_t>(rounds) * segments;
  double left_s = std::clamp(dt_s - rounds * cycle_s, 0.0, cycle_s);  // backwards: one round too far, then forwards
  for (std::uint32_t k = 0; k <= segments; ++k) {
    const double length_s = segment_length_s(group, at.beat), to_end_s = (1.0 - at.share) * length_s;
    if (left_s < to_end_s) break;
    left_s -= to_end_s;
    at = {at.beat + 1, 0.0};
  }
  const double share = at.share + left_s / segment_length_s(group, at.beat);
  at.share = below_1(share);
  return at;
}

CyclePlace cycle_place(const SyncMember& member, const BeatPlace& place) noexcept {
  return cycle_place(member.track, {place.beat + member.first_beat, place.share});
}

CyclePlace start_place(const SyncTrack& from, const CyclePlace& place, const SyncTrack& to, SyncStart rule) noexcept {
  switch (rule) {
    case SyncStart::phase: return {0, place.phase};
    case SyncStart::time_left: {
      const double left_s = (1.0 - place.phase) * from.length_s;
      return {0, left_s < to.length_s ? below_1(1.0 - left_s / to.length_s) : 0.0};
    }
    case SyncStart::beat: break;
  }
  const BeatPlace at = beat_place(from, place);
  const std::size_t index = floor_division(at.beat, beat_count(from)).rest;
  const std::size_t otherwise = index % beat_count(to);
  const std::size_t beat = from.beats.empty() ? otherwise : beat_of_name(to, name_of_beat(from, at.beat), otherwise);
  CyclePlace found = cycle_place(to, {static_cast<std::int64_t>(beat), at.share});
  found.round = 0;
  return found;
}

}  // namespace sinew
