// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/animation/bone_animation.h"
#include "runtime/base/api.h"
#include "runtime/base/run_job.h"
#include "runtime/pose/pose.h"
#include "runtime/retarget/feet_map.h"

namespace sinew {

/// Foot locking for a retargeted pose. A foot that is low on the source follows the source's path, scaled by the height
/// ratio. A standing foot then does not slide, and a foot that rolls over its toes still rolls. Without this, legs of
/// other proportions move the feet elsewhere. Feet keep their rotation. Thighs and shanks turn (turn_two_bones,
/// runtime/math/two_bones.h). If legs are too short, the hips come down by at most a fourth of a leg's length.
/// eq   goal = g + k (p - r): p is the place of the source's ankle or toes, whichever is lower, r its rest place,
///      g the rest place of the target's joint and k the height ratio. If p is the toes, the ankle moves as the toes
///      need.
///      The foot goes to goal + (1 - c) (place - goal). c(h) is 1 up to 4 % of the source's leg length above the
///      ground, 0 above 12 %, and smooth between. The result depends on the pose alone: nothing is remembered between
///      frames.
/// in   ground  height of the ground relative to the source's feet at rest, in units of the source (find_ground)
///      pose    [J source], in model space y is up;  held  [J target] the retargeted pose
/// out  held    rotations of the three joints of each low leg, or of all legs if the hips come down; the translation of
///      the hips
/// cost O(joints above and in the legs), no allocation
SINEW_API void hold_feet(const FeetMap& feet, double ground, std::span<const Transformd> pose,
                         std::span<Transformd> held) noexcept;

/// hold_feet in float, for the poses of frames.
/// err  size_mismatch     cost O(joints above and in the legs), no allocation
struct HoldFeetJob {
  const FeetMap* feet = nullptr;
  float ground = 0.0f;
  PoseSpan pose;  ///< pose of the source
  PoseSpan held;  ///< pose of the target, changed in place
};

SINEW_API ErrorCode check(const HoldFeetJob& job) noexcept;
SINEW_API void run_unchecked(const HoldFeetJob& job) noexcept;

/// Ground height of an animation, relative to the ground of the rest pose. It is the 5 % quantile over time of the
/// height of the lower foot, so a foot that dips through the floor for a moment does not count. 0 without legs.
/// cost O(duration * joints), allocates
SINEW_API double find_ground(const FeetMap& feet, const Animation& animation, const Skeleton& source);

/// Foot locking for a retargeted animation. Leg rotations, and translations of hips that come down, get linear keys at
/// all key times and 60 times a second. A leg that turns by no more than rounding keeps its tracks.
/// in   animation    of the source
///      retargeted   that animation after retarget_animation
/// out  retargeted   new tracks for the joints of legs and hips; new bones are appended
/// cost O(duration * joints), allocates
SINEW_API void hold_feet(const FeetMap& feet, const Animation& animation, const Skeleton& source,
                         const Skeleton& target, Animation& retargeted);

/// How far feet slide while they are on the ground. The slide of a contact is the largest distance of the ankle or toes
/// from the source's path. The path is scaled by the height ratio.
struct FootSlide {
  double largest = 0.0;  ///< over all contacts, in units of the target
  double mean = 0.0;
  std::size_t contacts = 0;
};

/// Measures how far feet slide in a retargeted animation.     cost O(duration * joints), allocates
SINEW_API FootSlide measure_foot_slide(const FeetMap& feet, const Animation& animation, const Skeleton& source,
                                       const Animation& retargeted, const Skeleton& target);

}  // namespace sinew
