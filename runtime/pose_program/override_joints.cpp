// SPDX-License-Identifier: MIT
#include "runtime/pose_program/override_joints.h"

#include <optional>

#include "runtime/base/index.h"
#include "runtime/math/decompose.h"
#include "runtime/math/inverse.h"
#include "runtime/pose_program/mix_poses.h"

namespace sinew {
namespace {

AffineT<double> model_matrix(const Skeleton& skeleton, const PoseSpan& pose, std::uint32_t joint) noexcept {
  AffineT<double> model;
  for (; joint != kNone; joint = skeleton.parents[joint]) {
    const std::uint32_t fixed = skeleton.fixed_matrix_of[joint];
    const Transform local = pose.get(joint);
    const AffineT<double> matrix =
        fixed != kNone
            ? affine_cast<double>(skeleton.fixed_matrices[fixed])
            : affine_from_transform(Transformd{Vec3<double>(local.translation), quat_cast<double>(local.rotation),
                                               Vec3<double>(local.scale)});
    model = matrix * model;
  }
  return model;
}

std::optional<Transform> local_transform(const Skeleton& skeleton, const PoseSpan& pose, const Affine& root,
                                         const JointOverride& given) noexcept {
  const bool in_world = given.space == OverrideSpace::world;
  if (given.space == OverrideSpace::local || (!in_world && skeleton.parents[given.joint] == kNone))
    return given.transform;
  const AffineT<double> above = model_matrix(skeleton, pose, skeleton.parents[given.joint]);
  const auto to_parent = inverse_of(in_world ? affine_cast<double>(root) * above : above);
  if (!to_parent) return std::nullopt;
  const Transformd there{Vec3<double>(given.transform.translation), quat_cast<double>(given.transform.rotation),
                         Vec3<double>(given.transform.scale)};
  const Transformd local = decompose_trs(*to_parent * affine_from_transform(there)).transform;
  return Transform{Vec3<float>(local.translation), quat_cast<float>(local.rotation), Vec3<float>(local.scale)};
}

}  // namespace

void override_joints(const Skeleton& skeleton, std::span<const JointOverride> joints, float share, const Affine& root,
                     const PoseSpan& pose) noexcept {
  for (const JointOverride& given : joints)
    if (const auto local = local_transform(skeleton, pose, root, given))
      pose.set(given.joint, mixed(pose.get(given.joint), *local, share));
}

}  // namespace sinew
