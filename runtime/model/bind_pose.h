// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "runtime/base/api.h"
#include "runtime/base/index.h"
#include "runtime/model/scene.h"

namespace sinew {

/// The pose in which the meshes of a scene were bound to their skins. Many files rest elsewhere, for example in a frame
/// of a walk.
struct BindPose {
  std::vector<Transform> local;        ///< [J] rotations unit; the bits of the rest pose wherever both agree
  std::vector<bool> is_bound;          ///< [J] the pose of the joint comes from an inverse bind matrix
  std::vector<std::uint32_t> differs;  ///< rising; joints that stand elsewhere at rest, relative to their parent.
  /// Rising; skins that were bound in another pose than a skin with more joints. `local` has the pose of the latter.
  std::vector<std::uint32_t> other_skins;
  double distance = 0.0;        ///< largest distance in model space between bind and rest, of a bound joint
  double size = 0.0;            ///< longest side of the box around the bound joints at rest
  std::uint32_t joint = kNone;  ///< the joint with the largest distance
};

/// Computes the bind pose as local transforms.
/// eq   M_j = X inverse(inverse_bind_j);  local_j = inverse(M_parent) M_j, without shear.
///      X cancels below the nearest ancestor a in the same skin: M_j = M_a inverse_bind_a inverse(inverse_bind_j)
///
/// X maps from the space in which a skin was bound to model space. The former may be scaled or turned (centimetres, z
/// up). Candidates for X are the model matrices of the mesh's node and of the ancestors of the skin's top joints, and
/// the identity. X is the candidate that leaves the top joints nearest to their rest pose. A candidate is rejected if
/// it scales a top joint, turns it by more than 60 degrees, or moves it by more than `size`. If none
/// is left, X combines quarter turns and a scale, if that leaves the first top joint near its rest pose. Otherwise X
/// places that joint at its rest pose. X also does so if the joints of the skin are posed alike, relative to each
/// other, at bind and at rest.
///
/// Joints outside of skins keep their rest transform relative to their parent, and so do joints with fixed matrices.
/// Skins with more joints come first; a joint takes its place from the first skin that lists it. A skin is ignored if
/// its inverse bind matrices are all the same or cannot be inverted.
/// cost O(J * depth + joints of skins), allocates
SINEW_API BindPose bind_pose(const Scene& scene);

}  // namespace sinew
