// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/animation/bone_animation.h"
#include "runtime/base/api.h"
#include "runtime/math/dual_quaternion.h"
#include "runtime/playback/playback_clock.h"

namespace sinew {

/// The part of a root joint's rotation that moves the character.
enum class RootTurn : std::uint8_t {
  none,
  heading,  ///< about +Y only: the twist of swing_twist.h, whichever way the joint leans
  full,
  heading_euler,  ///< about +Y only: the first Euler angle of Ry Rz Rx, the direction of +X seen from above. It is
                  ///< not defined where +X is vertical, and there the rotation counts as Ry Rz
};

/// The parts of a root joint's transform that move the character through the world. All other parts stay in its pose.
struct RootMotionParts {
  bool x = true, y = false, z = true;  ///< translation along the axes of the joint's parent space
  RootTurn turn = RootTurn::heading;
};

/// Position and rotation of the character at a clip time: the given parts of the root joint's local transform.
/// eq   E(t) = T(given axes of the translation) * H(t),  H = R(t) R_rest^-1; for RootTurn::heading its twist about +Y,
///      for RootTurn::heading_euler the angle y of H = Ry(y) Rz(z) Rx(x)
/// in   rest  of the root joint: used for properties without a track, and as the direction of heading 0
/// out  rigid, unit.  cost O(log K), no allocation
SINEW_API DualQuatd root_place(const BoneAnimation& root, const Transform& rest, const RootMotionParts& parts,
                               double time_s) noexcept;

/// The movement of the character in a step of the clock, in its own space.
/// eq   D = E(from)^-1 E(to) within a round;  over rounds of a loop, each continues where the last one ended:
///      D = E(from)^-1 (E(end) E(0)^-1)^turns E(to), the power by repeated squaring;  a whole round of ping-pong moves
///      nothing.
///      The product of the movements of several steps equals that of one long step, so the frame rate does not matter.
///
///     const PlaybackStep step = clock.advance(dt_s);
///     world = normalised(world * root_motion(root, rest, parts, step));
///     frame.root = world * inverse of root_place(root, rest, parts, clock.time_s());   // removes it from the pose
///
/// With several clips, blend both the motion and the place that is removed: blend_root_motion. RootTrack (root_track.h)
/// gives the same without the authoring keys.
/// out  rigid, unit.  cost O(log K + log turns), no allocation
SINEW_API DualQuatd root_motion(const BoneAnimation& root, const Transform& rest, const RootMotionParts& parts,
                                const PlaybackStep& step) noexcept;

/// The part of one clip in a blend of root motions.
struct RootShare {
  DualQuatd motion;     ///< root_motion of the clip in this frame
  DualQuatd place;      ///< root_place at the clip's time
  double weight = 0.0;  ///< of the clip's layer
};

/// The blended motion of the character, and the place to remove from the blended pose.
struct BlendedRoot {
  DualQuatd motion, place;
};

/// Root motion of clips that blend.
/// eq   Both are means over sum w, as blend_poses makes them: translations linearly, rotations as quaternions of one
///      hemisphere. The blended root joint stands at the mean of the clips' places. Removing the place of only one clip
///      would leave a part of the motion in the pose, and the character would move twice.
///
///     world = normalised(world * blended.motion);
///     frame.root = world * inverse of blended.place;
///
/// in   weights at least 0, of the layers that blend.   out  identities where no weight is above 0
SINEW_API BlendedRoot blend_root_motion(std::span<const RootShare> shares) noexcept;

/// The root motion of a mirrored clip: the motion of the clip, reflected at a plane through the origin.
/// eq   S D S:  q' = n q n^-1,  t' = t - 2 n (n . t), n the normal as a pure quaternion
/// in   plane_normal  unit, in the space of the motion (MirrorMap::plane_normal for a root joint without parents)
SINEW_API DualQuatd mirrored_motion(const DualQuatd& motion, const Vec3<double>& plane_normal) noexcept;

}  // namespace sinew
