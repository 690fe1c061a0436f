// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/math/affine.h"

namespace sinew {

enum class FollowKind : std::uint8_t { root, joint_override, procedure };

/// The place in a follower's input that follows a joint of another character (JobThread::follow). With M the world
/// matrix of the leader's joint and R the world matrix of the follower's root:
/// eq   root            root' = M root: a rider, a prop
///      joint_override  transform' = R^-1 M transform, as translation, rotation and scale (decompose_trs): a hand that
///                      holds another character's prop. The override must be in OverrideSpace::model
///      procedure       *matrix = R^-1 M: the target of a look-at or of IK.
/// Versions of the override and the procedure then also stand for M and R (0 stays 0). So an unchanged
/// target runs nothing.
struct FollowPlace {
  FollowKind kind = FollowKind::root;
  std::uint32_t list = 0;    ///< joint_override, procedure: index into the list of the follower's PoseProgramInputs
  std::uint32_t entry = 0;   ///< joint_override: index into JointOverrides::joints
  Affine* matrix = nullptr;  ///< procedure: the matrix that the procedure reads, of this place alone. Frames write it
                             ///< before the procedure runs, so only the procedure may use it while frames run

  /// True if both name the same place, whatever their matrix is.
  bool is_same_place(const FollowPlace& other) const noexcept {
    return kind == other.kind && (kind == FollowKind::root || list == other.list) &&
           (kind != FollowKind::joint_override || entry == other.entry);
  }
};

}  // namespace sinew
