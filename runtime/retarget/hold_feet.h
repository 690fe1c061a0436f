// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/animation/bone_animation.h"
#include "runtime/base/run_job.h"
#include "runtime/pose/pose.h"
#include "runtime/retarget/feet_map.h"

namespace sinew {

/// Holds the feet of a retargeted pose: a foot that is low on the source follows the source's path, scaled by heights,
/// so that one that stands still stands still, and one that rolls over its toes rolls. Legs of other proportions would
/// carry it elsewhere. Feet keep their rotation; thighs and shanks turn (turn_two_bones, runtime/math/two_bones.h), and
/// where legs are too short the hips come down, by at most a fourth of a leg's length.
/// eq   goal = g + k (p - r), p the place of the source's ankle or of its toes, whichever is lower, r and g its places
///      and the target's while the source rests, k the ratio; where toes count, the ankle goes by as much as they must.
///      The foot goes to goal + (1 - c) (place - goal); c(h) is 1 below 4 % of the length of the source's leg above the
///      ground, 0 above 12 %, smooth between. A function of the pose alone: nothing is remembered between frames.
/// in   ground  height of the ground below the source's feet at rest, in units of the source (find_ground)
///      pose    [J source], in model space y is up;  held  [J target] the retargeted pose
/// out  held    rotations of the three joints of each leg that is low, or of all legs where the hips come down; the
///              translation of the hips
/// cost O(joints above and in the legs), no allocation
void hold_feet(const FeetMap& feet, double ground, std::span<const Transformd> pose,
               std::span<Transformd> held) noexcept;

/// The same in float, for poses of frames.
/// err  size_mismatch     cost O(joints above and in the legs), no allocation
struct HoldFeetJob {
  const FeetMap* feet = nullptr;
  float ground = 0.0f;
  PoseSpan pose;  ///< of the source
  PoseSpan held;  ///< of the target, in place
};

ErrorCode check(const HoldFeetJob& job) noexcept;
void run_unchecked(const HoldFeetJob& job) noexcept;

/// Height of the ground of an animation, above that on which the rest pose stands: the height of the lower foot that
/// one time in twenty is below, so that a foot which dips through the floor for a moment does not count. 0 without
/// legs.
/// cost O(duration * joints), allocates
double find_ground(const FeetMap& feet, const Animation& animation, const Skeleton& source);

}  // namespace sinew
