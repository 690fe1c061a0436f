// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/clip/clip.h"

namespace sinew {

/// A clip with its packed keys as floats again: samples as fast as a clip that was never packed, and takes the memory
/// of float keys. For clips that are stored within a budget (compress/compile_clip_within.h) but played often. Keys
/// that the budget removed stay removed.
///
/// Poses on keys are those of `clip`, with rotations normalised. Between keys they differ from those of `clip` by less
/// than its rounding, because slerp of packed keys does not normalise them first. The certificate is kept: its error
/// was measured on both forms.
/// cost O(keys), allocates
Clip unpacked(const Clip& clip);

}  // namespace sinew
