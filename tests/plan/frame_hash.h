// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/plan/frame_hash.h"

namespace sinew::test {

/// Hash of all numbers of a frame, bit by bit.
inline std::uint64_t hash_of(const FrameResult& frame) {
  const std::uint64_t parts[] = {hash_pose(frame), hash_vertices(frame)};
  BitHash hash;
  hash.add(std::span(parts));
  for (const InstanceResult& i : frame.instances) {
    const float box[] = {i.bounds.lower.x, i.bounds.lower.y, i.bounds.lower.z,        i.bounds.upper.x,
                         i.bounds.upper.y, i.bounds.upper.z, i.mirrored ? 1.0f : 0.0f};
    hash.add(std::span(box)).add(std::span(&i.world_from_mesh, 1));
  }
  return hash.value();
}

}  // namespace sinew::test
