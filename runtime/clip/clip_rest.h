// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "runtime/clip/base_numbers.h"
#include "runtime/clip/clip.h"

namespace sinew {

/// Rest values of joints, morph weights and properties. Clips that are compiled with the same ClipRest share them.
struct ClipRest {
  std::size_t joint_count = 0;
  RestNumbers pose;  ///< in the order of BasePose::planes
  RestNumbers weights, properties;
};

/// cost O(joints + weights + properties), allocates
ClipRest clip_rest(const Skeleton& skeleton, std::span<const float> rest_weights, const PropertyTable& properties);

/// Replaces arrays of `rest` by those of the clip if they have the same bits, so that they exist once.
/// cost O(joints + weights + properties)
void share_rest(const Clip& clip, ClipRest& rest);

/// As compile_clip in clip.h, for clips that share rest values.
/// in   rest  clip_rest() of the same skeleton, weights and properties
/// cost O(total keys), whatever the number of joints; allocates the clip
Clip compile_clip(const Animation& animation, const ClipRest& rest, std::span<const std::uint32_t> first_weight,
                  const PropertyTable& properties = {}, const KeyTolerances& rounding = {});

}  // namespace sinew
