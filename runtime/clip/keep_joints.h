// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/clip/clip.h"

namespace sinew {

/// A skeleton with only the given joints, in their order, without names and node indices.
/// in   joints  rising; they contain the parent of each of them
/// cost O(J), allocates
Skeleton keep_joints(const Skeleton& skeleton, std::span<const std::uint32_t> joints);

/// The clip for that skeleton, without the tracks of other joints. The remaining tracks sample the same bits at every
/// time. Morph weights and properties do not change.
/// in   joints  rising
/// cost O(keys + J), allocates the clip
Clip keep_joints(const Clip& clip, std::span<const std::uint32_t> joints);

/// As above, for several clips. Data shared between the inputs stays shared in the outputs.
std::vector<Clip> keep_joints(std::span<const Clip> clips, std::span<const std::uint32_t> joints);

}  // namespace sinew
