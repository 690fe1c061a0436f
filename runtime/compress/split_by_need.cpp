// SPDX-License-Identifier: MIT
#include "runtime/compress/split_by_need.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace sinew {
namespace {

constexpr std::size_t kKeysLookedAt = 2048;  ///< enough to tell tracks apart
constexpr int kDepth = 2;
constexpr std::size_t kPlaces = 8;  ///< a list is tried cut at each eighth

std::size_t keys_of(std::span<const LooseTrack> tracks) {
  return keys_needed(tracks, std::min(tracks.front().times_s().size(), kKeysLookedAt)).size();
}

/// Packed keys take about a third of full ones.
std::size_t bytes_per_key(const LooseTrack& track) {
  return std::visit([](const auto* t) { return (t->values.size() / t->key_count() * sizeof(t->values[0]) + 2) / 3; },
                    track.track);
}

std::size_t cost_of(std::span<const LooseTrack> tracks) {
  std::size_t row = 2 * sizeof(float);  // of the key times and their search table
  for (const LooseTrack& track : tracks) row += bytes_per_key(track);
  return kPartBytes + keys_of(tracks) * row;
}

/// Cuts a list that is ordered by need, and its halves again, where that is cheaper.
void cut(std::span<const LooseTrack> tracks, int depth, std::vector<std::vector<LooseTrack>>& parts) {
  std::size_t best_cost = cost_of(tracks), best = 0;
  for (std::size_t i = 1; depth > 0 && i < kPlaces; ++i) {
    const std::size_t place = tracks.size() * i / kPlaces;
    if (place == 0 || place == tracks.size() * (i - 1) / kPlaces) continue;
    const std::size_t cost = cost_of(tracks.first(place)) + cost_of(tracks.subspan(place));
    if (cost < best_cost) best_cost = cost, best = place;
  }
  if (best == 0) return parts.emplace_back(tracks.begin(), tracks.end()), void();
  cut(tracks.first(best), depth - 1, parts);
  cut(tracks.subspan(best), depth - 1, parts);
}

}  // namespace

std::vector<std::vector<LooseTrack>> split_by_need(std::vector<LooseTrack> tracks) {
  std::vector<std::pair<std::size_t, std::size_t>> order;  // keys that the track needs alone, its number
  for (std::size_t i = 0; i < tracks.size(); ++i) order.emplace_back(keys_of({&tracks[i], 1}), i);
  std::sort(order.begin(), order.end());
  std::vector<LooseTrack> by_need;
  std::transform(order.begin(), order.end(), std::back_inserter(by_need),
                 [&](const auto& o) { return tracks[o.second]; });
  std::vector<std::vector<LooseTrack>> parts;
  cut(by_need, kDepth, parts);
  return parts;
}

}  // namespace sinew
