// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/base/bit_hash.h"
#include "runtime/plan/frame_result.h"

namespace sinew {

/// Hash of a pose: the bits of all world matrices and morph weights of the result. It does not depend on the number of
/// threads or the instruction set.
/// cost O(J + W), no allocation
inline std::uint64_t hash_pose(const FrameResult& frame) noexcept {
  return BitHash().add(frame.model).add(frame.weights).value();
}

/// Hash of the bits of all deformed vertices. It does not depend on the number of threads. Instruction sets with fused
/// multiply-add agree with each other, and so do those without (conventions.h).
/// cost O(V), no allocation
inline std::uint64_t hash_vertices(const FrameResult& frame) noexcept {
  BitHash hash;
  for (const DeformedPrimitive& p : frame.primitives)
    hash.add(p.positions).add(p.normals).add(p.tangents).add(p.colors);
  return hash.value();
}

}  // namespace sinew
