// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/clip/clip_layout.h"

namespace sinew {

inline bool is_of_joints(const TrackBlock& block) noexcept { return block.property < Property::weight; }

/// Appends to `out` blocks with the lanes of `block` under new targets; lanes without a new target are dropped. The
/// lanes sample the same bits at every time. If all lanes stay, in the same order, the keys are shared with `block`;
/// otherwise they are copied.
/// in   new_target  of each old target; kNone = dropped; all others are distinct
///      key_count   of the block's group
void add_moved_lanes(const TrackBlock& block, std::span<const std::uint32_t> new_target, std::size_t key_count,
                     std::vector<TrackBlock>& out);

}  // namespace sinew
