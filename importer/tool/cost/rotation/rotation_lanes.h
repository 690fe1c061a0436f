// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/clip/clip.h"
#include "runtime/pose/pose.h"

namespace sinew::cost {

/// Ways to go from one rotation key to the next in place of slerp; approximate_slerp.h describes them.
enum class ArcRule : unsigned char { nlerp, corrected_nlerp, polynomial_slerp };

/// Samples a clip in lanes as SampleClipJob does, over the same data, but with another rule between rotation keys.
/// in    clip   all its rotation tracks are linear; nothing else is sampled
/// out   pose   with the clip's joint count
/// cost  that of SampleClipJob; no allocation
void sample_rotations(const Clip& clip, double time_s, ArcRule rule, const PoseSpan& pose) noexcept;

}  // namespace sinew::cost
