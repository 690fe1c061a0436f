// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/clip/clip.h"

namespace sinew {

/// A copy of the clip with its packed keys as floats. It samples as fast as a clip that was never packed, and takes as
/// much memory. For clips that are stored within an error budget (compress/compile_clip_within.h) but played often.
/// Keys that the budget removed stay removed.
///
/// At keys the poses are those of `clip`, with rotations normalised. Between keys they differ by less than the
/// rounding of `clip`, since sampling packed keys does not normalise them first. The certificate is kept, since it was
/// measured on both forms.
/// cost O(keys), allocates
Clip unpacked(const Clip& clip);

}  // namespace sinew
