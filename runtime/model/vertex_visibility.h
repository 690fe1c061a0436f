// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "runtime/base/index.h"

namespace sinew {

/// Ambient visibility is the share of ambient light that reaches a vertex: 1 - ambient occlusion.
/// [mesh][primitive][V] in [0, 1]. A mesh has one value per vertex, so several instances and copies of it share the
/// mean of theirs. Primitives that are not shown, points and lines have none.
using MeshVisibility = std::vector<std::vector<std::vector<float>>>;

inline constexpr std::uint32_t kMostKeyPoses = 64;

/// Ambient visibility baked at vertices, for one pose or for several key poses of a clip.
struct VertexVisibility {
  std::vector<double> times_s = {0.0};  ///< [P] rising times of the key poses
  std::uint32_t clip = kNone;           ///< the clip of the key poses; unused with one pose
  MeshVisibility values;                ///< with [P * V] in place of [V], pose after pose; empty = no occlusion
};

}  // namespace sinew
