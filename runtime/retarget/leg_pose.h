// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>

#include "runtime/math/quaternion.h"
#include "runtime/math/transform.h"
#include "runtime/retarget/feet_map.h"

namespace sinew {

/// A joint of a leg in model space. Internal to retarget/
template <class T>
struct PlacedJoint {
  Vec3<T> place{T(0)};
  Quat<T> rotation = quat_identity<T>();
  Quat<T> above = quat_identity<T>();  ///< rotation of its parent
};

template <class T>
struct LegPose {
  PlacedJoint<T> upper, lower, foot, toes;
  AffineT<T> above_hips = affine_from_transform(TransformT<T>{});  ///< matrix of the parent of the hips
};

/// in   local_of(joint)  returns the local transform of a joint in the pose
template <class T, class LocalOf>
LegPose<T> leg_pose(const LegChain& chain, const LocalOf& local_of) {
  LegPose<T> pose;
  AffineT<T> matrix = affine_from_transform(TransformT<T>{});
  Quat<T> rotation = quat_identity<T>();
  for (std::size_t i = 0; i < chain.joints.size(); ++i) {
    const LegJoint& joint = chain.joints[i];
    const TransformT<T> local = joint.is_fixed
                                    ? TransformT<T>{Vec3<T>(joint.rest.translation), quat_cast<T>(joint.rest.rotation),
                                                    Vec3<T>(joint.rest.scale)}
                                    : local_of(joint.joint);
    const Quat<T> above = rotation;
    if (i == chain.hips) pose.above_hips = matrix;
    rotation = normalised(above * local.rotation);
    matrix = matrix * affine_from_transform(local);
    const PlacedJoint<T> placed{translation_of(matrix), rotation, above};
    if (i == chain.upper) pose.upper = placed;
    if (i == chain.lower) pose.lower = placed;
    if (i == chain.foot) pose.foot = placed;
    if (i == chain.toes) pose.toes = placed;
  }
  return pose;
}

}  // namespace sinew
