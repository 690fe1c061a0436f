// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "runtime/compress/remove_keys.h"

namespace sinew {

/// Tracks that share their key times, in parts that each keep keys of their own where that takes fewer bytes: a track
/// that needs every key would otherwise hold them for all. Every part is a time group of the clip, with a key search
/// and tables of its own (kPartBytes), so there are never more than a few. in   tracks  at least one      cost
/// O(keys_needed), a few times
std::vector<std::vector<LooseTrack>> split_by_need(std::vector<LooseTrack> tracks);
inline constexpr std::size_t kPartBytes = 512;

}  // namespace sinew
