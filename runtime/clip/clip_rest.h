// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "runtime/clip/base_numbers.h"
#include "runtime/clip/clip.h"

namespace sinew {

/// What joints, morph weights and properties are without a clip. Clips that are compiled with one of these share it.
struct ClipRest {
  std::size_t joint_count = 0;
  RestNumbers pose;  ///< the planes of BasePose
  RestNumbers weights, properties;
};

/// cost O(joints + weights + properties), allocates
ClipRest clip_rest(const Skeleton& skeleton, std::span<const float> rest_weights, const PropertyTable& properties);

/// Takes the numbers of a clip in place of those with the same bits, so that they exist once.
/// cost O(joints + weights + properties)
void share_rest(const Clip& clip, ClipRest& rest);

/// compile_clip (clip.h) for clips that share what is at rest.
/// in   rest        of the skeleton, of the weights that `first_weight` counts, and of `properties`
/// cost O(total keys), whatever the number of joints; allocates the clip
Clip compile_clip(const Animation& animation, const ClipRest& rest, std::span<const std::uint32_t> first_weight,
                  const PropertyTable& properties = {}, const KeyTolerances& rounding = {});

}  // namespace sinew
