// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/math/affine.h"
#include "runtime/pose/pose.h"

namespace sinew {

/// The pose of a frame whose first half has run, in memory of the frame buffer.
struct CutPose {
  PoseSpan local;                 ///< [K] may be written: bodies of a physics engine, IK of the caller
  std::span<const Affine> model;  ///< [K] world matrices of that pose; empty if the plan composes none
};

}  // namespace sinew
