// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "runtime/animation/mirror_map.h"

namespace sinew {

/// The pose in which a body is symmetric, in double precision.
struct ReferencePose {
  std::vector<Transformd> local;       ///< [J] rotations unit; fixed matrices are taken apart
  std::vector<Quat<double>> rotation;  ///< [J] model space: the product of rotations down the hierarchy
  std::vector<Affined> model;          ///< [J]
  double size = 0.0;                   ///< longest side of the box around the joints

  Vec3<double> position(std::uint32_t joint) const noexcept { return translation_of(model[joint]); }
};

/// in   local  [J] or empty for the rest pose
ReferencePose reference_pose(const Skeleton& skeleton, std::span<const Transform> local);

/// Which joints are partners at which plane.
struct JointPairs {
  Vec3<double> normal{1.0, 0.0, 0.0};
  double offset = 0.0;                  ///< of the plane along its normal
  std::vector<std::uint32_t> partner;   ///< [J] itself where it has none; partner[partner[j]] = j
  std::vector<bool> keeps_own;          ///< [J] no partner, though the parent has one: its local motion is not mirrored
  std::vector<std::uint32_t> unpaired;  ///< as in MirrorMap

  double distance(const Vec3<double>& point) const noexcept { return glm::dot(normal, point) - offset; }
  Vec3<double> reflected(const Vec3<double>& point) const noexcept { return point - normal * (2.0 * distance(point)); }
};

/// Partners by the options, by names, then by places. Parents of partners are always partners.
/// Internal to animation/
JointPairs pair_joints(const Skeleton& skeleton, const ReferencePose& reference, const MirrorOptions& options);

}  // namespace sinew
