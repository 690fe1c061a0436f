// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/animation/bone_animation.h"
#include "runtime/retarget/skeleton_map.h"

namespace sinew {

/// A pose of the source on the target, plainly and in double precision.
/// eq   that of make_skeleton_map (skeleton_map.h). Joints that nothing is mapped to have their rest pose.
/// in   pose  [J source] local transforms;   out  [J target] local transforms
/// cost O(J), no allocation
void retarget_pose(const SkeletonMap& map, const Skeleton& source, const Skeleton& target,
                   std::span<const Transformd> pose, std::span<Transformd> out) noexcept;

/// An animation of the source as one of the target. Where a target joint follows one track alone, each key is mapped by
/// itself and the interpolation stays: the map is linear in it, so nothing is resampled and the animation is that of
/// retarget_pose at every time, but for rounding; on its own skeleton an animation keeps its bits. Where several joints
/// of the source add up (a spine of more joints, a wrist), there are linear keys at the key times of all of them, and
/// at the middles between these.
/// Scales are left out unless the skeletons share names. Morph weights and properties are the business of
/// retarget_weights.h and retarget_properties.h.
/// in   animation  checked, of the source
/// cost O(keys * joints between mapped ones), allocates
Animation retarget_animation(const Animation& animation, const SkeletonMap& map, const Skeleton& source,
                             const Skeleton& target);

/// How far an animation is from the poses that it was made of, at and between `per_second` times a second.
struct RetargetError {
  double angle_rad = 0.0;       ///< largest, of a local rotation
  double distance = 0.0;        ///< largest, of a local translation, in units of the target
  std::uint32_t joint = kNone;  ///< of the target, where the angle is
};
RetargetError measure_retarget(const Animation& retargeted, const Animation& animation, const SkeletonMap& map,
                               const Skeleton& source, const Skeleton& target, double per_second = 97.0);

}  // namespace sinew
