// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "runtime/base/index.h"
#include "runtime/math/transform.h"

namespace sinew {

/// Skeleton LOD: which joints poses have. A joint that is left out has no track, no transform and no matrix in any
/// frame. It hangs rigidly on the nearest joint above that is kept; vertices, meshes, cameras and lights on it follow
/// that one. compile_skeleton_lod (compile_skeleton_lod.h) finds the joints that move vertices least, and by how much.
///
/// The LODs of a character are several plans of one scene. To change level, run the other plan into another frame
/// buffer, or into a new one over the same block of memory. On a job thread every level is a character of its own, and
/// all but one are asleep.
struct SkeletonLod {
  std::vector<bool>
      kept;  ///< [J] empty = all. Roots, joints above kept ones, and joints that drive correctives stay too
  std::vector<Transform> held;  ///< [J] local transforms of the joints that are left out; empty = the rest pose. Joints
                                ///< with a fixed matrix keep it
};

/// A skeleton LOD, and how far it was seen to move vertices.
struct CompiledSkeletonLod {
  SkeletonLod detail;
  double tolerance_m = 0.0;    ///< that was asked for
  std::uint32_t left_out = 0;  ///< joints
  double measured_m = 0.0;     ///< largest displacement that was found: of the virtual vertices of joints that are
                               ///< left out, and of vertices in the frames that were compared
  std::uint32_t worst_joint = kNone;  ///< the joint whose virtual vertices moved most
};

}  // namespace sinew
