// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
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

/// Places the joints of a leg in model space.
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

/// How firmly the foot of the source stands on the ground, and on which part. Internal to retarget/
template <class T>
struct FootContact {
  T held = T(0);       ///< 0 in the air, 1 on the ground
  T toes = T(0);       ///< share of the toes in the contact: 0 where the ankle is lower, 1 where the toes are lower
  Vec3<T> foot{T(0)};  ///< displacement of the ankle from its rest place, in the source
  Vec3<T> ball{T(0)};  ///< displacement of the ball of the foot from its rest place, in the source
};

/// Smoothstep: 0 below `low`, 1 above `high`.
template <class T>
T smooth_step(T low, T high, T x) noexcept {
  const T t = std::clamp((x - low) / (high - low), T(0), T(1));
  return t * t * (T(3) - T(2) * t);
}

/// Height above the rest pose of the ankle or the toes, whichever is lower.
template <class T>
T lowest_height(const LegPair& leg, const LegPose<T>& pose) noexcept {
  const T foot = pose.foot.place.y - static_cast<T>(leg.source_foot.y);
  return leg.source.toes == 0 ? foot : std::min(foot, pose.toes.place.y - static_cast<T>(leg.source_toes.y));
}

template <class T>
FootContact<T> foot_contact(const LegPair& leg, const LegPose<T>& source, T ground) noexcept {
  const T length = static_cast<T>(leg.source_length);
  FootContact<T> contact;
  contact.foot = source.foot.place - Vec3<T>(leg.source_foot);
  contact.held = T(1) - smooth_step(T(0.04) * length, T(0.12) * length, lowest_height(leg, source) - ground);
  if (leg.source.toes == 0) return contact;
  contact.ball = source.toes.place - Vec3<T>(leg.source_toes);
  contact.toes = smooth_step(T(-0.02) * length, T(0.02) * length, contact.foot.y - contact.ball.y);
  return contact;
}

/// Place of the target's ankle when its foot is fully held.
template <class T>
Vec3<T> foot_goal(const LegPair& leg, const FootContact<T>& contact, T ratio, const LegPose<T>& target) noexcept {
  const Vec3<T> by_foot = Vec3<T>(leg.target_foot) + contact.foot * ratio;
  if (leg.target.toes == 0) return by_foot;
  const Vec3<T> by_toes = Vec3<T>(leg.target_toes) + contact.ball * ratio + (target.foot.place - target.toes.place);
  return by_foot + (by_toes - by_foot) * contact.toes;
}

}  // namespace sinew
