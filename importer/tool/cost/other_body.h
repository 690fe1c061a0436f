// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <optional>

#include "runtime/animation/skeleton.h"

namespace sinew::cost {

/// A body of other proportions on the same joints, to which the clips of a file are retargeted. It is three quarters as
/// large; beyond that its legs are a tenth shorter, its arms a tenth longer. Its feet stand where those of the body do.
struct OtherBody {
  Skeleton skeleton;
  std::array<std::uint32_t, 2> hands{}, feet{};  ///< joints of both bodies
};

/// Makes the other body. Empty if the names of joints do not tell hips, arms and legs.
std::optional<OtherBody> other_body(const Skeleton& skeleton);

}  // namespace sinew::cost
