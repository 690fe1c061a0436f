// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/clip/clip.h"

namespace sinew {

/// A skeleton of some joints only, numbered in their order, without names and nodes.
/// in   joints  rising; with a joint also its parent
/// cost O(J), allocates
Skeleton keep_joints(const Skeleton& skeleton, std::span<const std::uint32_t> joints);

/// The clip of that skeleton: without the tracks of other joints. The tracks left sample the same bits at every time;
/// morph weights and properties stay as they are. Works for exact, packed and loaded clips.
/// in   joints  rising
/// cost O(keys + J), allocates the clip
Clip keep_joints(const Clip& clip, std::span<const std::uint32_t> joints);

/// The same for clips of one scene: what they share they go on sharing.
std::vector<Clip> keep_joints(std::span<const Clip> clips, std::span<const std::uint32_t> joints);

}  // namespace sinew
