// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "runtime/math/affine.h"
#include "runtime/plan/rig.h"

namespace sinew {

/// How far from rigid a matrix may be. A product is as far as the farther of its factors.
enum class ScaleKind : std::uint8_t {
  none,   ///< lengths stay
  even,   ///< all directions by one factor, mirrored or not
  uneven  ///< or sheared
};

/// What scale reaches a joint in any pose, from the joint itself and from those above it, but for the frame's root.
struct JointScale {
  ScaleKind kind = ScaleKind::none;
  int sign = 1;             ///< of the determinant, where it does not change: 0 where scale is nothing
  bool may_change = false;  ///< the sign
};

/// From rest pose, constants and keys of all clips. Tracks that may leave the range of their keys (cubic, rounded) may
/// do anything. in   additive   layers may add: where scale is not always the same, it may get any sign out  [joints of
/// the rig]      cost O(J + keys of scale tracks), allocates
std::vector<JointScale> joint_scales(const Rig& rig, bool additive);

/// Of a matrix as it stands; what rounding leaves of an even one (1e-5 of its size) is even.
ScaleKind scale_kind(const Affine& m) noexcept;

/// -1, 0 or 1. In double: the product of three small scales must not vanish.
int determinant_sign(const Affined& m) noexcept;

}  // namespace sinew
