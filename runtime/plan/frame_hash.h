// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include "runtime/plan/frame_result.h"

namespace sinew {

/// Hash of numbers by their bits: the step of 64-bit FNV-1a (Fowler, Noll, Vo) taken over 32-bit words. Each step is one to
/// one, so that two runs that differ in a single number never agree.
class BitHash {
 public:
  /// in   values  of a type made of 32-bit or 64-bit numbers, without padding
  template <class T, std::size_t kCount>
  BitHash& add(std::span<T, kCount> values) noexcept {
    static_assert(sizeof(T) % sizeof(std::uint32_t) == 0);
    const std::span<const std::byte> bytes = std::as_bytes(values);
    for (std::size_t i = 0; i < bytes.size(); i += sizeof(std::uint32_t)) {
      std::uint32_t word;
      std::memcpy(&word, &bytes[i], sizeof word);
      value_ = (value_ ^ word) * 0x100000001b3ull;
    }
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

/// Bits of all deformed vertices. The same for every thread count, on all instruction sets with fused multiply-add, and on all
/// without (conventions.h).     cost O(V), no allocation
inline std::uint64_t hash_vertices(const FrameResult& frame) noexcept {
  BitHash hash;
  for (const DeformedPrimitive& p : frame.primitives) hash.add(p.positions).add(p.normals).add(p.tangents).add(p.colors);
  return hash.value();
}

}  // namespace sinew
