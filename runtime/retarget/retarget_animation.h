// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/animation/bone_animation.h"
#include "runtime/base/api.h"
#include "runtime/retarget/skeleton_map.h"

namespace sinew {

/// Reference implementation of retargeting one pose, in double precision.
/// eq   as make_skeleton_map (skeleton_map.h). Unmapped joints stand in the reference pose.
/// in   pose  [J source] local transforms;   out  [J target] local transforms
/// cost O(J), no allocation
SINEW_API void retarget_pose(const SkeletonMap& map, const Skeleton& source, const Skeleton& target,
                             std::span<const Transformd> pose, std::span<Transformd> out) noexcept;

/// Retargets an animation of the source to the target. Where a target joint follows a single track, each key is mapped
/// by itself and keeps its interpolation. The map is linear in the key, so nothing is resampled: at every time the
/// result equals retarget_pose up to rounding. An animation that is retargeted to its own skeleton keeps its bits. If a
/// reference pose is not the rest pose, a joint without tracks may have to stand elsewhere than at rest. It gets a
/// constant track then. Several source joints may add up, as in a spine with more joints. The target joint then gets
/// linear keys at the key times of all of them and halfway between. Scales are left out unless the skeletons share
/// names. For morph weights and properties see retarget_weights.h and retarget_properties.h.
/// in   animation  of the source; must have passed its checks
/// cost O(keys * joints between mapped ones), allocates
SINEW_API Animation retarget_animation(const Animation& animation, const SkeletonMap& map, const Skeleton& source,
                                       const Skeleton& target);

/// Largest difference between a retargeted animation and retarget_pose of the original, sampled `per_second` times a
/// second and halfway between.
struct RetargetError {
  double angle_rad = 0.0;       ///< largest difference of local rotations
  double distance = 0.0;        ///< largest difference of local translations, in units of the target
  std::uint32_t joint = kNone;  ///< joint of the target with the largest angle
};
SINEW_API RetargetError measure_retarget(const Animation& retargeted, const Animation& animation,
                                         const SkeletonMap& map, const Skeleton& source, const Skeleton& target,
                                         double per_second = 97.0);

}  // namespace sinew
