// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/clip/clip.h"

namespace sinew {

/// A part of a clip in time. It samples the bits of the whole clip at all times from `first_s` to `last_s`: of each
/// track it has the keys from the last one at or before `first_s` to the first one at or after `last_s`. Name, duration
/// and certificate stay those of the whole. Numbers at rest are shared.
/// in   first_s <= last_s, seconds in the clip; infinities take all keys on that side
/// cost O(keys of the part + tracks), allocates the part
Clip cut_clip(const Clip& clip, double first_s, double last_s);

/// The first key of every track: what is known of a clip whose keys are elsewhere. A plan that is compiled with it can
/// play any part of the clip (ClipLayer::page), because it holds no key for a promise about the others.
/// cost O(tracks), allocates
Clip first_keys(const Clip& clip);

}  // namespace sinew
