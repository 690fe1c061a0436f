// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/clip/clip.h"

namespace sinew {

/// A clip whose rounded keys are full floats again, with what slerp needs between them: as fast to sample as one that
/// was never rounded, for the memory of its keys in float. For clips that are stored within a budget
/// (compress/compile_clip_within.h) but played often; keys that were left out stay so.
///
/// Keys are what `clip` has, rotations among them made unit; between keys whose lengths were rounded apart poses differ
/// by a part of that rounding. The certificate is kept: it is of both. cost O(keys), allocates
Clip unpacked(const Clip& clip);

}  // namespace sinew
