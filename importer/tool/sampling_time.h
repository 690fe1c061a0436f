// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/clip/clip.h"

namespace sinew::tool {

/// What a sample takes on this machine, in nanoseconds per joint: the median of runs at times all over the clip, joints
/// and weights together. Takes some milliseconds.
double sampling_ns_per_joint(const Clip& clip);

}  // namespace sinew::tool
