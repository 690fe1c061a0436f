// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "runtime/math/conventions.h"

namespace sinew {

/// Displacements of one attribute by a morph target, only for the vertices that it moves.
template <class V>
struct SparseDeltas {
  std::vector<std::uint32_t> vertices;
  std::vector<V> deltas;  ///< parallel to `vertices`; the importer leaves out zero vectors

  bool empty() const noexcept { return vertices.empty(); }
};

/// One morph target of a primitive. Tangents change in x, y, z only; colours are clamped to [0, 1] after the sum.
/// eq   attribute' = attribute + sum over targets of weight * delta, before skinning   (glTF 2.0, "Morph Targets")
struct MorphTarget {
  SparseDeltas<glm::vec3> positions, normals, tangents;
  SparseDeltas<glm::vec4> colors;                  ///< displacements of COLOR_0
  std::vector<SparseDeltas<glm::vec2>> texcoords;  ///< displacements of each TEXCOORD_n
};

/// The morph targets of one primitive; all primitives of a mesh have the same number of targets.
struct MorphSet {
  std::vector<MorphTarget> targets;

  bool empty() const noexcept { return targets.empty(); }
};

}  // namespace sinew
