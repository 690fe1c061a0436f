// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/model/mesh.h"
#include "tests/support/fixed_random.h"

namespace sinew::scenes {

/// A head-sized sphere of `vertex_count` vertices with `target_count` expressions. Each expression moves the positions
/// and normals of one connected patch: one vertex in `sparsity`.
inline Primitive face(std::uint32_t vertex_count, std::uint32_t target_count, std::uint32_t sparsity = 4) {
  test::FixedRandom random(target_count);
  Primitive p;
  for (std::uint32_t v = 0; v < vertex_count; ++v) {
    const glm::vec3 n = random.direction();
    p.positions.push_back(n * 0.12f);
    p.normals.push_back(n);
  }
  for (std::uint32_t v = 0; v + 2 < vertex_count; v += 3) p.indices.insert(p.indices.end(), {v, v + 1, v + 2});
  const std::uint32_t patch = vertex_count / sparsity;
  for (std::uint32_t t = 0; t < target_count; ++t) {
    MorphTarget target;
    const std::uint32_t first = random.below(vertex_count - patch + 1);
    for (std::uint32_t v = first; v < first + patch; ++v) {
      target.positions.vertices.push_back(v);
      target.positions.deltas.push_back(random.vec3(-0.02, 0.02));
      target.normals.vertices.push_back(v);
      target.normals.deltas.push_back(random.vec3(-0.2, 0.2));
    }
    p.morphs.targets.push_back(std::move(target));
  }
  for (const glm::vec3& position : p.positions) p.bounds.add(position);
  return p;
}

}  // namespace sinew::scenes
