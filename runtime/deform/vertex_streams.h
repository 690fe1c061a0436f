// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/math/conventions.h"

namespace sinew {

/// The vertex attributes that deformation reads. Empty normals or tangents = not wanted.
struct VertexInput {
  std::span<const glm::vec3> positions;
  std::span<const glm::vec3> normals;
  std::span<const glm::vec4> tangents;  ///< w = handedness, copied through
};

/// Where deformation writes. An attribute is written when it is present in the input *and* not empty here.
struct VertexOutput {
  std::span<glm::vec3> positions;
  std::span<glm::vec3> normals;   ///< unit
  std::span<glm::vec4> tangents;  ///< unit xyz
};

}  // namespace sinew
