// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "runtime/animation/bone_animation.h"
#include "runtime/animation/skeleton.h"

namespace sinew::cost {

/// True where it matters how one gets from key to key.
bool is_between_keys(const QuatTrack& track);

/// The rotations of an animation that are between keys, and nothing else of it, made by `interpolation` from the same
/// keys. Cubic tracks keep their tangents when they stay cubic; others get those of the parabola through neighbouring
/// keys.
Animation rotations_only(const Animation& animation, Interpolation interpolation);

/// The same joints and tracks side by side `copies` times, as a crowd has them: enough lanes for a time per joint that
/// is not that of the call.
struct Crowd {
  Skeleton skeleton;
  Animation animation;
};
Crowd crowd_of(const Skeleton& skeleton, const Animation& animation, std::size_t copies);

/// The rotations that frames 0, 1, ... at `fps` show when each run of frames between two keys is walked in equal steps
/// (incremental_slerp.h); a run's first and last frame are slerped.
void walk_track(const QuatTrack& track, double fps, std::span<glm::quat> frames);

}  // namespace sinew::cost
