// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "runtime/plan/frame_result.h"

namespace sinew {

/// 64-bit FNV-1a (Fowler, Noll, Vo) over the bytes of numbers, in memory order: equal bits, equal hash.
class BitHash {
 public:
  template <class T, std::size_t kCount>
  BitHash& add(std::span<T, kCount> values) noexcept {
    for (const std::byte b : std::as_bytes(values)) value_ = (value_ ^ static_cast<std::uint64_t>(b)) * 0x100000001b3ull;
    return *this;
  }
  std::uint64_t value() const noexcept { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325ull;
};

/// Bits of a pose: the world matrices of all joints and all morph weights. The same for every thread count and on every
/// instruction set (N27, N28).     cost O(J + W), no allocation
inline std::uint64_t hash_pose(const FrameResult& frame) noexcept {
  return BitHash().add(frame.model).add(frame.weights).value();
}

/// Bits of all deformed vertices. The same for every thread count, and on every instruction set with fused multiply-add
/// (conventions.h).     cost O(V), no allocation
inline std::uint64_t hash_vertices(const FrameResult& frame) noexcept {
  BitHash hash;
  for (const DeformedPrimitive& p : frame.primitives) hash.add(p.positions).add(p.normals).add(p.tangents).add(p.colors);
  return hash.value();
}

}  // namespace sinew
