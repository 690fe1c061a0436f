// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/base/bit_hash.h"
#include "runtime/plan/frame_result.h"

namespace sinew {

/// Bits of a pose: the world matrices of all joints and all morph weights. The same for every thread count and on every
/// instruction set (N27, N28).     cost O(J + W), no allocation
inline std::uint64_t hash_pose(const FrameResult& frame) noexcept {
  return BitHash().add(frame.model).add(frame.weights).value();
}

/// Bits of all deformed vertices. The same for every thread count, on all instruction sets with fused multiply-add, and
/// on all without (conventions.h).     cost O(V), no allocation
inline std::uint64_t hash_vertices(const FrameResult& frame) noexcept {
  BitHash hash;
  for (const DeformedPrimitive& p : frame.primitives)
    hash.add(p.positions).add(p.normals).add(p.tangents).add(p.colors);
  return hash.value();
}

}  // namespace sinew
