// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <cstring>
#include <span>

#include "runtime/plan/frame_result.h"

namespace sinew::test {

/// FNV-1a over bytes.
class Hash {
 public:
  template <class T, std::size_t kCount>
  Hash& add(std::span<T, kCount> values) {
    for (const std::byte b : std::as_bytes(values))
      value_ = (value_ ^ static_cast<std::uint64_t>(b)) * 0x100000001b3ull;
    return *this;
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325ull;
};

/// All numbers that a frame shows, bit by bit.
inline std::uint64_t hash_of(const FrameResult& frame) {
  Hash hash;
  hash.add(frame.model).add(frame.weights);
  for (const InstanceResult& i : frame.instances) {
    const float box[] = {i.bounds.lower.x, i.bounds.lower.y, i.bounds.lower.z,        i.bounds.upper.x,
                         i.bounds.upper.y, i.bounds.upper.z, i.mirrored ? 1.0f : 0.0f};
    hash.add(std::span(box)).add(std::span(&i.world_from_mesh, 1));
  }
  for (const DeformedPrimitive& p : frame.primitives)
    hash.add(p.positions).add(p.normals).add(p.tangents).add(p.colors);
  return hash.value();
}

}  // namespace sinew::test
