// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/animation/mirror_map.h"

namespace sinew {

/// The symmetric pose of a skeleton, in double precision.
struct ReferencePose {
  std::vector<Transformd> local;       ///< [J] rotations unit; fixed matrices are decomposed
  std::vector<Quat<double>> rotation;  ///< [J] model space: the product of the local rotations from the root down
  std::vector<Affined> model;          ///< [J] model matrices
  double size = 0.0;                   ///< longest side of the box around the joints

  Vec3<double> position(std::uint32_t joint) const noexcept { return translation_of(model[joint]); }
};

/// Computes the reference pose in local and model space.
/// in   local  [J], or empty for the rest pose
ReferencePose reference_pose(const Skeleton& skeleton, std::span<const Transform> local);

/// The mirror plane, and the partner of each joint.
struct JointPairs {
  Vec3<double> normal{1.0, 0.0, 0.0};
  double offset = 0.0;                  ///< distance of the plane from the origin, along its normal
  std::vector<std::uint32_t> partner;   ///< [J] itself if it has none; partner[partner[j]] = j
  std::vector<bool> keeps_own;          ///< [J] it has no partner, but its parent has: its local motion is not mirrored
  std::vector<std::uint32_t> unpaired;  ///< as in MirrorMap

  double distance(const Vec3<double>& point) const noexcept { return glm::dot(normal, point) - offset; }
  Vec3<double> reflected(const Vec3<double>& point) const noexcept { return point - normal * (2.0 * distance(point)); }
};

/// Finds partners by the options, by names, then by positions. Parents of partners are always partners.
JointPairs pair_joints(const Skeleton& skeleton, const ReferencePose& reference, const MirrorOptions& options);

/// Joints that should be where the mirror image of their partner is. Joints that keep their own motion, or are in
/// `unpaired`, are left out.
/// out  rising
std::vector<std::uint32_t> symmetric_joints(const JointPairs& pairs);

/// Mean distance of joints from the mirror image of their partner, relative to the size of the skeleton.
double asymmetry_of(const ReferencePose& reference, const JointPairs& pairs,
                    std::span<const std::uint32_t> joints) noexcept;

}  // namespace sinew
