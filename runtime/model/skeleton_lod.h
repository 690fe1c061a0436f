// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "runtime/base/index.h"
#include "runtime/math/transform.h"

namespace sinew {

/// A skeleton LOD: the joints that are evaluated. A joint that is left out has no track, transform or matrix in any
/// frame. It is rigidly attached to the nearest kept joint above, and its vertices, meshes, cameras and lights follow
/// that joint. compile_skeleton_lod (lod/compile_skeleton_lod.h) finds the joints that move vertices least, and
/// measures by how much.
///
/// The LODs of a character are several plans of one scene. To change level, run the other plan with another frame
/// buffer, or with a new one over the same block of memory. On a job thread each level is a character, and all but one
/// are asleep.
struct SkeletonLod {
  /// [J] empty = all. Roots, joints above kept ones and joints that drive correctives are always kept.
  std::vector<bool> kept;
  /// [J] local transforms of the joints that are left out; empty = the rest pose. Fixed matrices stay.
  std::vector<Transform> held;
};

/// A skeleton LOD with its measured error.
struct CompiledSkeletonLod {
  SkeletonLod detail;
  double tolerance_m = 0.0;    ///< the requested limit
  std::uint32_t left_out = 0;  ///< number of joints
  /// Largest displacement from the full skeleton, over the sampled moments of the clips. It covers the virtual vertices
  /// (compress/virtual_vertices.h) of left-out joints. If the skinning is not linear, whole frames were evaluated too,
  /// and it covers their vertices.
  double measured_m = 0.0;
  std::uint32_t worst_joint = kNone;  ///< the joint whose virtual vertices moved most
};

}  // namespace sinew
