// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "tests/support/fixed_random.h"
#include "tests/support/skinned_vertices.h"

namespace sinew::test {

/// Gives the vertices of each group the joints of its first `sets` vertices, in shuffled orders. In the first half of
/// the group, vertices with equal joints follow each other. In the second half, each vertex takes one of the sets at
/// random.
inline void share_joints(FixedRandom& random, SkinnedVertices& s, std::uint32_t sets) {
  for (const InfluenceGroup& group : s.influences.groups) {
    const std::uint32_t half = group.vertex_count / 2;
    for (std::uint32_t v = sets; v < group.vertex_count; ++v) {
      const std::uint32_t from = v < half ? v * sets / half : random.below(sets);
      const auto joints = s.influences.joints.begin() + group.first_influence;
      const auto own = joints + v * group.influence_count;
      std::copy_n(joints + from * group.influence_count, group.influence_count, own);
      for (std::uint32_t i = group.influence_count; i > 1; --i) std::swap(own[i - 1], own[random.below(i)]);
    }
  }
}

}  // namespace sinew::test
