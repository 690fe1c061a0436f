// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/clip/clip.h"

namespace sinew {

/// The part of a clip between two times. Each track keeps the keys from the last one at or before `first_s` to the
/// first one at or after `last_s`. So the part samples the same bits as the whole clip at times from `first_s` to
/// `last_s`. Name, duration and certificate are those of the whole clip. Rest values are shared.
/// in   first_s <= last_s, clip time; infinities keep all keys on that side
/// cost O(keys of the part + tracks), allocates the part
Clip cut_clip(const Clip& clip, double first_s, double last_s);

/// The clip with only the first key of every track; it stands for a clip whose other keys are not loaded. A plan that
/// was compiled with it can play any part of the clip (ClipLayer::page): it assumes nothing about other keys.
/// cost O(tracks), allocates
Clip first_keys(const Clip& clip);

}  // namespace sinew
