// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "runtime/base/index.h"

namespace sinew {

/// Ambient visibility of the vertices of each mesh, [mesh][primitive][V] in [0, 1]. A mesh has one value for a vertex,
/// wherever it is placed, so several instances and copies get the mean of theirs. Primitives that are not shown, points
/// and lines have none.
using MeshVisibility = std::vector<std::vector<std::vector<float>>>;

inline constexpr std::uint32_t kMostKeyPoses = 64;

/// Ambient visibility that was baked at vertices, for one pose or for key poses of a clip.
struct VertexVisibility {
  std::vector<double> times_s = {0.0};  ///< [P] rising, of the key poses
  std::uint32_t clip = kNone;           ///< the clip of the key poses; with one pose it does not matter
  MeshVisibility values;                ///< with [P * V] in place of [V], pose after pose; empty = all light arrives
};

}  // namespace sinew
