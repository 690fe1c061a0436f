// SPDX-License-Identifier: MIT
#include "runtime/sync/sync_track.h"

#include <cmath>

#include "runtime/sync/floor_division.h"

namespace sinew {
namespace {

/// Phase at which a beat of round 0 starts. For index = number of beats it is the start of beat 0 plus 1.
double start_of(const SyncTrack& track, std::size_t beat) noexcept {
  if (track.beats.empty()) return static_cast<double>(beat);
  const std::size_t count = track.beats.size();
  return beat < count ? track.beats[beat].phase : 1.0 + track.beats[beat - count].phase;
}

}  // namespace

ErrorCode check(const SyncTrack& track) noexcept {
  if (!std::isfinite(track.length_s)) return ErrorCode::not_finite;
  if (!(track.length_s > 0.0)) return ErrorCode::not_a_fraction;
  double last = -1.0;
  for (const SyncBeat& beat : track.beats) {
    if (!std::isfinite(beat.phase)) return ErrorCode::not_finite;
    if (!(beat.phase >= 0.0 && beat.phase < 1.0 && beat.phase > last)) return ErrorCode::times_not_increasing;
    if (!track.mirrored_names.empty() && beat.name >= track.mirrored_names.size()) return ErrorCode::index_out_of_range;
    last = beat.phase;
  }
  return ErrorCode::ok;
}

std::size_t beat_count(const SyncTrack& track) noexcept { return track.beats.empty() ? 1 : track.beats.size(); }

std::uint32_t name_of_beat(const SyncTrack& track, std::int64_t beat) noexcept {
  if (track.beats.empty()) return 0;
  const std::uint32_t name = track.beats[floor_division(beat, track.beats.size()).rest].name;
  return track.mirrored_names.empty() ? name : track.mirrored_names[name];
}

double beat_length(const SyncTrack& track, std::int64_t beat) noexcept {
  const std::size_t k = floor_division(beat, beat_count(track)).rest;
  return start_of(track, k + 1) - start_of(track, k);
}

BeatPlace beat_place(const SyncTrack& track, const CyclePlace& place) noexcept {
  const auto count = static_cast<std::int64_t>(beat_count(track));
  std::int64_t k = count - 1;
  while (k >= 0 && start_of(track, static_cast<std::size_t>(k)) > place.phase) --k;
  const bool in_round_before = k < 0;  // the last beat of the round before lasts into this round
  const auto beat = static_cast<std::size_t>(in_round_before ? count - 1 : k);
  const double start = start_of(track, beat), phase = in_round_before ? place.phase + 1.0 : place.phase;
  return {place.round * count + k, below_1((phase - start) / (start_of(track, beat + 1) - start))};
}

CyclePlace cycle_place(const SyncTrack& track, const BeatPlace& place) noexcept {
  const FloorDivision at = floor_division(place.beat, beat_count(track));
  const double start = start_of(track, at.rest), end = start_of(track, at.rest + 1);
  const double phase = start + place.share * (end - start);
  return phase < 1.0 ? CyclePlace{at.quotient, phase} : CyclePlace{at.quotient + 1, below_1(phase - 1.0)};
}

}  // namespace sinew
