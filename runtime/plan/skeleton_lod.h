// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "runtime/math/transform.h"

namespace sinew {

/// Which joints poses are made of. A joint that is left out has no track, no transform and no matrix in any frame: it
/// hangs rigidly on the nearest joint above that is kept, and vertices, meshes, cameras and lights on it follow that
/// one. compile_skeleton_lod (compile_skeleton_lod.h) finds the joints that matter least.
///
/// Several plans of one scene, each with a detail of its own, are the levels of a character: it changes level by
/// running the other plan, into another frame buffer or into a new one over the same block of memory; on a job thread
/// every level is a character of its own there, and all but one are asleep. Nothing jumps farther than joints were
/// allowed to move vertices.
struct SkeletonLod {
  std::vector<bool>
      kept;  ///< [J] empty = all. Roots, joints above those kept, and joints that drive correctives are kept too
  std::vector<Transform> held;  ///< [J] how joints that are left out stand to their parents; empty = as in the rest
                                ///< pose. Joints with a fixed matrix stay there
};

}  // namespace sinew
