// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/animation/bone_animation.h"
#include "runtime/animation/skeleton.h"

namespace sinew {

/// Which parts of a transform differ from the rest transform by more than rounding.
struct RestDifference {
  bool translation = false, rotation = false, scale = false;

  bool any() const noexcept { return translation || rotation || scale; }
};

RestDifference rest_difference(const Transform& local, const Transform& rest) noexcept;

/// Adds a constant track for each property of a joint that no track moves, but that must differ from its rest value.
/// Joints with fixed matrices get none.
/// in   local  [J] where joints without tracks must stand
/// cost O(bones + J), allocates
void add_constant_tracks(std::span<const Transform> local, const Skeleton& skeleton, Animation& animation);

}  // namespace sinew
