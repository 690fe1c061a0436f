// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <vector>

#include "runtime/model/scene.h"

namespace sinew::cost {

using LocalPose = std::vector<Transformd>;
using ModelPose = std::vector<Affined>;

/// Local transforms of all joints in double precision, from the authoring form. Everything is compared with them.
LocalPose true_local_pose(const Skeleton& skeleton, const Animation& animation, double time_s);
LocalPose rest_pose(const Skeleton& skeleton);

/// A pose for files without clips: every joint with a parent is rotated by 30 degrees about x, y or z in turn.
LocalPose crooked_pose(const Skeleton& skeleton);

/// Model matrices of a pose.
/// eq   M[j] = M[parent(j)] * T * R * S, in double
ModelPose model_pose(const Skeleton& skeleton, std::span<const Transformd> local);

/// Times at which errors between keys are largest, in at most `most_intervals` key intervals that are evenly picked.
/// Each has four: its first key, its middle, and the two places where nlerp is farthest from slerp. Increasing; {0}
/// without keys.
std::vector<double> times_of_large_errors(const Animation& animation, std::size_t most_intervals);

/// Times at which a clip is sampled while it is timed: one in each sixteenth of it, away from usual keys. Their order
/// jumps forwards and backwards.
std::vector<double> timed_moments(double duration_s);

}  // namespace sinew::cost
