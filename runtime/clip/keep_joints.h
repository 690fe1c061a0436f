// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "runtime/clip/clip.h"

namespace sinew {

/// A skeleton of some joints alone, numbered as they come; names and nodes are the whole skeleton's.
/// in   joints  rising, with the parent of each
/// cost O(J), allocates
Skeleton keep_joints(const Skeleton& skeleton, std::span<const std::uint32_t> joints);

/// The clip without the tracks of other joints, for that skeleton. What is left has the same bits at every time; morph
/// weights and properties stay as they are. Exact, packed and loaded clips alike. in   joints  rising cost O(keys),
/// allocates the clip
Clip keep_joints(const Clip& clip, std::span<const std::uint32_t> joints);

}  // namespace sinew
