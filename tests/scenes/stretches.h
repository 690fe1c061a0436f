// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/model/scene.h"

namespace sinew::test {

/// Gives each `length` consecutive vertices of an influence group the same joints. Their weights stay their own. Real
/// meshes are like that: plans sort their vertices into tiles.
inline void share_joints_in_stretches(Scene& scene, std::uint32_t length) {
  for (Mesh& mesh : scene.meshes)
    for (Primitive& primitive : mesh.primitives)
      for (const InfluenceGroup& group : primitive.influences.groups)
        for (std::uint32_t v = 0; v < group.vertex_count; ++v)
          for (std::uint32_t i = 0; i < group.influence_count; ++i) {
            std::uint16_t* joints = &primitive.influences.joints[group.first_influence];
            joints[v * group.influence_count + i] = joints[(v - v % length) * group.influence_count + i];
          }
}

}  // namespace sinew::test
