// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "runtime/clip/clip.h"
#include "runtime/clip/clip_rest.h"

namespace sinew {

/// Where the numbers of a clip go in another skeleton or model; kNone = nowhere. No two go to the same place.
struct ClipTargets {
  std::vector<std::uint32_t> joints;   ///< [joints of the clip]
  std::vector<std::uint32_t> weights;  ///< [morph weights of the clip]
  std::vector<std::uint32_t> numbers;  ///< [numbers of animated properties of the clip]
};

/// What a clip moves: by a track, or by a constant other than the value at rest.
struct ClipMotion {
  std::vector<bool> joints, weights, numbers;
};

/// in   rest  of the skeleton and the model that the clip was compiled for
/// cost O(tracks + joints + weights + numbers), allocates
ClipMotion motion_of(const Clip& clip, const ClipRest& rest);

/// The clip for another skeleton or model. What it moves has the bits that it had, as far as it has a target; all else
/// is as it is at rest there. Local transforms stay as they are: a body of other proportions needs runtime/retarget.
/// A constant equal to the value at rest in `from` is no motion.
/// The certificate stays where joints and their rest pose stay, as it was measured with them.
/// in   from  rest of the skeleton and the model that the clip was compiled for
///      to    rest where it shall play
/// out  `clip` itself where nothing differs. Else a clip that shares the keys of blocks whose lanes stay in order.
/// cost O(tracks + joints + weights + numbers); O(keys) of lanes that do not stay in order; allocates
Clip rebind_clip(const Clip& clip, const ClipRest& from, const ClipTargets& targets, const ClipRest& to);

}  // namespace sinew
