// SPDX-License-Identifier: MIT
#include "runtime/sync/common_beats.h"

#include <algorithm>
#include <array>
#include <bit>

namespace sinew {
namespace {

struct Row {
  std::array<std::uint32_t, kMostCommonBeats> names;
  std::size_t count = 0;
};

Row row_of(const SyncTrack& track, std::uint32_t mask) noexcept {
  Row row;
  for (std::size_t b = 0; b < track.beats.size(); ++b)
    if ((mask >> b & 1u) != 0) row.names[row.count++] = name_of_beat(track, static_cast<std::int64_t>(b));
  return row;
}

/// Finds the beats of a track that have the names of the row in order, from any first beat on. Returns their bits, or 0
/// if there are none.
std::uint32_t beats_of_row(const SyncTrack& track, const Row& row) noexcept {
  const std::size_t beats = track.beats.size();
  for (std::size_t first = 0; first < beats; ++first) {
    std::uint32_t mask = 0;
    std::size_t said = 0;
    for (std::size_t b = first; b < first + beats && said < row.count; ++b)
      if (name_of_beat(track, static_cast<std::int64_t>(b)) == row.names[said]) {
        mask |= 1u << b % beats;
        ++said;
      }
    if (said == row.count) return mask;
  }
  return 0;
}

}  // namespace

std::uint32_t find_common_beats(std::span<const SyncTrack> tracks, std::span<std::uint32_t> kept) noexcept {
  std::fill(kept.begin(), kept.end(), 0u);
  if (tracks.empty()) return 0;
  const bool fit = std::all_of(tracks.begin(), tracks.end(),
                               [](const SyncTrack& track) { return track.beats.size() <= kMostCommonBeats; });
  std::uint32_t best = 0;
  for (std::uint32_t mask = 1; fit && mask < 1u << tracks[0].beats.size(); ++mask) {
    if (std::popcount(mask) <= std::popcount(best)) continue;
    const Row row = row_of(tracks[0], mask);
    if (std::all_of(tracks.begin(), tracks.end(), [&](const SyncTrack& t) { return beats_of_row(t, row) != 0; }))
      best = mask;
  }
  if (best == 0) return 0;
  const Row row = row_of(tracks[0], best);
  for (std::size_t t = 0; t < tracks.size(); ++t) kept[t] = beats_of_row(tracks[t], row);
  return static_cast<std::uint32_t>(std::popcount(best));
}

}  // namespace sinew
