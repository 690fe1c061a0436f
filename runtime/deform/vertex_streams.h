// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/math/conventions.h"

namespace sinew {

/// Vertex attributes that deformation reads. Empty normals or tangents = the mesh has none.
struct VertexInput {
  std::span<const glm::vec3> positions;
  std::span<const glm::vec3> normals;
  std::span<const glm::vec4> tangents;  ///< w = handedness, copied through
};

/// Vertex attributes that deformation writes. It writes an attribute if the input has it and its span here is not
/// empty.
struct VertexOutput {
  std::span<glm::vec3> positions;
  std::span<glm::vec3> normals;   ///< unit
  std::span<glm::vec4> tangents;  ///< unit xyz
};

}  // namespace sinew
