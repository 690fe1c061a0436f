// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/clip/clip.h"
#include "runtime/pose/pose.h"

namespace sinew::cost {

/// Ways to go from one rotation key to the next in place of slerp (approximate_slerp.h says what each of them is).
enum class ArcRule : unsigned char { nlerp, corrected_nlerp, polynomial_slerp };

/// Samples a clip as SampleClipJob does, in lanes over the same data, but goes between rotation keys by another rule.
/// in   clip  whose rotation tracks are all linear; nothing else is sampled
/// out  pose  of the clip's joint count                cost as SampleClipJob's, no allocation
void sample_rotations(const Clip& clip, double time_s, ArcRule rule, const PoseSpan& pose) noexcept;

}  // namespace sinew::cost
