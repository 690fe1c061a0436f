// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/clip/clip_layout.h"

namespace sinew {

inline bool is_of_joints(const TrackBlock& block) noexcept { return block.property < Property::weight; }

/// Adds to `out` the lanes of a block with other targets, without those that have none. They sample the same bits at
/// every time. Where all lanes stay in their order, the keys are shared with `block`; else those of the lanes are
/// copied.
/// in   new_target  of each old target, kNone = none; no two are the same
///      key_count   of the group
void add_moved_lanes(const TrackBlock& block, std::span<const std::uint32_t> new_target, std::size_t key_count,
                     std::vector<TrackBlock>& out);

}  // namespace sinew
