// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "runtime/base/api.h"
#include "runtime/math/affine.h"
#include "runtime/plan/plan_assets.h"

namespace sinew {

/// How far from rigid a matrix may be. The kind of a product is at most the larger kind of its factors.
enum class ScaleKind : std::uint8_t {
  none,   ///< lengths stay
  even,   ///< all directions scale by one factor, mirrored or not
  uneven  ///< directions scale differently, or the matrix shears
};

/// The scale that can reach a joint in any pose, from the joint itself and from those above it, without the frame's
/// root.
struct JointScale {
  ScaleKind kind = ScaleKind::none;
  int sign = 1;             ///< sign of the determinant, if it does not change; 0 if some scale is 0
  bool may_change = false;  ///< the sign can change
};

/// Finds the scales from the rest pose and from the constants and keys of all clips. Tracks that may leave the range of
/// their keys (cubic, rounded) count as reaching any scale.
/// in   additive   layers may add: a scale that changes at all may get any sign
/// out  [joints of poses]      cost O(J + keys of scale tracks), allocates. Internal to plan/
SINEW_API std::vector<JointScale> joint_scales(const PlanAssets& assets, bool additive);

/// The kind of one matrix. Differences below 1e-5 of its size count as rounding: the matrix is even.
SINEW_API ScaleKind scale_kind(const Affine& m) noexcept;

}  // namespace sinew
