// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/base/api.h"
#include "runtime/clip/clip.h"

namespace sinew {

/// A skeleton with only the given joints, in their order, without names and node indices.
/// in   joints  rising; the parent of each joint must be among them
/// cost O(J), allocates
SINEW_API Skeleton keep_joints(const Skeleton& skeleton, std::span<const std::uint32_t> joints);

/// A copy of the clip for the skeleton that keep_joints makes of the same joints. It has no tracks of other joints. The
/// remaining tracks sample the same bits at every time. Morph weights and properties do not change.
/// in   joints  rising
/// cost O(keys + J), allocates the clip
SINEW_API Clip keep_joints(const Clip& clip, std::span<const std::uint32_t> joints);

/// As above, for several clips. Data shared between the inputs stays shared in the outputs.
SINEW_API std::vector<Clip> keep_joints(std::span<const Clip> clips, std::span<const std::uint32_t> joints);

}  // namespace sinew
