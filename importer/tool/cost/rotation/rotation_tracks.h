// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "runtime/animation/bone_animation.h"
#include "runtime/animation/skeleton.h"

namespace sinew::cost {

/// True where the interpolation between keys makes a difference: at least two keys, not step, and not all equal.
bool is_between_keys(const QuatTrack& track);

/// The rotation tracks of an animation for which is_between_keys() holds, with the same keys and another interpolation.
/// Cubic tracks that stay cubic keep their tangents; other tracks get those of the parabola through neighbouring keys.
Animation rotations_only(const Animation& animation, Interpolation interpolation);

/// A skeleton and an animation repeated side by side, as in a crowd. There are enough lanes that the overhead of a call
/// does not count.
struct Crowd {
  Skeleton skeleton;
  Animation animation;
};
Crowd crowd_of(const Skeleton& skeleton, const Animation& animation, std::size_t copies);

/// The rotations of frames 0, 1, ... at `fps` when the frames between two keys are walked in equal steps
/// (incremental_slerp.h). The first and last frame of each walk are slerped.
void walk_track(const QuatTrack& track, double fps, std::span<glm::quat> frames);

}  // namespace sinew::cost
