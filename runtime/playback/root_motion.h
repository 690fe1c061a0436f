// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/animation/bone_animation.h"
#include "runtime/math/dual_quaternion.h"
#include "runtime/playback/playback_clock.h"

namespace sinew {

/// How much of a root joint's turning carries the character.
enum class RootTurn : std::uint8_t {
  none,
  heading,  ///< about +Y only
  full,
};

/// The part of a root joint's movement that carries the character through the world; the rest stays in its pose.
struct RootMotionParts {
  bool x = true, y = false, z = true;  ///< translation along the axes of the joint's parent space
  RootTurn turn = RootTurn::heading;
};

/// Where the animation carries the character to at a clip time: the named parts of the root joint's local transform.
/// eq   E(t) = T(named axes of the translation) * H(t),  H = R(t) R_rest^-1, for a heading only its twist about +Y
/// in   rest  of the root joint, for what the animation leaves alone and as the direction of heading 0
/// out  rigid, unit.  cost O(log K), no allocation
DualQuatd root_place(const BoneAnimation& root, const Transform& rest, const RootMotionParts& parts,
                     double time_s) noexcept;

/// How far the character moves in a step of the clock, in its own space (U07).
/// eq   D = E(from)^-1 E(to) within a round;  over rounds of a loop, each goes on where the last one ended:
///      D = E(from)^-1 (E(end) E(0)^-1)^turns E(to), the power by repeated squaring;  forth and back moves nothing.
///      Deltas telescope: their product over any frames from a to b is that of one step from a to b, so that neither
///      the frame rate nor the number of rounds matters.
///
///     const PlaybackStep step = clock.advance(dt_s);
///     world = normalised(world * root_motion(root, rest, parts, step));
///     frame.root = world * inverse of root_place(root, rest, parts, clock.time_s());   // takes it out of the pose
///
/// out  rigid, unit.  cost O(log K + log turns), no allocation
DualQuatd root_motion(const BoneAnimation& root, const Transform& rest, const RootMotionParts& parts,
                      const PlaybackStep& step) noexcept;

/// The motion of a mirrored clip: that of the clip, reflected at the plane through the origin.
/// eq   S D S:  q' = n q n^-1,  t' = t - 2 n (n . t), n the normal as a pure quaternion
/// in   plane_normal  unit, in the space of the motion (MirrorMap::plane_normal for a root joint without parents)
DualQuatd mirrored_motion(const DualQuatd& motion, const Vec3<double>& plane_normal) noexcept;

}  // namespace sinew
