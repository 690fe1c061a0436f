// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "runtime/clip/clip.h"
#include "runtime/clip/clip_rest.h"

namespace sinew {

/// Indices of the clip's channels in another skeleton or model; kNone = dropped. All others are distinct.
struct ClipTargets {
  std::vector<std::uint32_t> joints;   ///< [joints of the clip] new index of each joint
  std::vector<std::uint32_t> weights;  ///< [morph weights of the clip] new index of each weight
  std::vector<std::uint32_t> numbers;  ///< [components of animated properties of the clip] new index of each
};

/// Channels that a clip moves, by a track or by a constant that differs from the rest value.
struct ClipMotion {
  std::vector<bool> joints, weights, numbers;
};

/// Finds the channels that a clip moves.
/// in   rest  that the clip was compiled with
/// cost O(tracks + joints + weights + numbers), allocates
ClipMotion motion_of(const Clip& clip, const ClipRest& rest);

/// The clip for another skeleton or model. Channels that the clip moves and that have a target keep their bits. All
/// other channels have the rest values in `to`. A constant equal to the rest value in `from` does not count as moved.
/// Local transforms do not change: a body with other proportions needs runtime/retarget. The certificate is kept only
/// if joints and rest pose are the same, since it was measured with them.
/// in   from  rest values that the clip was compiled with
///      to    rest values of the skeleton and model that it will play on
/// out  `clip` itself if nothing differs. Otherwise it shares the keys of blocks whose lanes stay in order.
/// cost O(tracks + joints + weights + numbers); O(keys) for blocks whose lanes do not stay in order; allocates
Clip rebind_clip(const Clip& clip, const ClipRest& from, const ClipTargets& targets, const ClipRest& to);

}  // namespace sinew
