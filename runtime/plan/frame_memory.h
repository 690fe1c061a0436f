// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstddef>
#include <span>

#include "runtime/pose/pose.h"

namespace sinew {

/// An array inside the memory of a frame.
template <class T>
struct Block {
  std::size_t offset = 0;  ///< bytes from the start of the memory, a multiple of the alignment of T
  std::size_t count = 0;

  Block part(std::size_t first, std::size_t part_count) const noexcept {
    return {offset + first * sizeof(T), part_count};
  }
};

/// A pose inside the memory of a frame.
struct PoseBlock {
  Block<float> planes;
  std::size_t joint_count = 0;
};

/// A pose with its morph weights and properties, inside the memory of a frame.
struct PoseBlocks {
  PoseBlock pose;
  Block<float> weights, properties;
};

/// View of PoseBlocks.
struct PoseNumbers {
  PoseSpan pose;
  std::span<float> weights, properties;
};

inline void copy_pose(const PoseSpan& from, const PoseSpan& to) noexcept {
  std::copy_n(from.planes, PoseSpan::floats_for(from.joint_count), to.planes);
}

/// Copies morph weights and properties.
inline void copy_numbers(const PoseNumbers& from, const PoseNumbers& to) noexcept {
  std::copy(from.weights.begin(), from.weights.end(), to.weights.begin());
  std::copy(from.properties.begin(), from.properties.end(), to.properties.begin());
}

/// The memory of one frame. The blocks of the plan's FrameLayout are offsets into it.
struct FrameMemory {
  std::byte* start = nullptr;

  template <class T>
  std::span<T> of(const Block<T>& block) const noexcept {
    return {reinterpret_cast<T*>(start + block.offset), block.count};
  }
  PoseSpan of(const PoseBlock& block) const noexcept { return pose_over(of(block.planes), block.joint_count); }
  PoseNumbers of(const PoseBlocks& blocks) const noexcept {
    return {of(blocks.pose), of(blocks.weights), of(blocks.properties)};
  }
};

}  // namespace sinew
