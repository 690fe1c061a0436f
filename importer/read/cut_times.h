// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>

#include "importer/read/animations.h"

namespace sinew {

/// Replaces the keys before time 0 by one key at 0 that has the value there. From 0 on the curve stays as it was:
/// a part of a line, of an arc or of a Hermite cubic is again one. Tracks begin at 0, and so do clips. The new key of a
/// cubic rotation is scaled to unit length, which turns later rotations before the next key by a fraction of a degree.
/// in,out  data       times are finite and never decrease; as many values as the interpolation needs
/// in      rotation   linear keys are interpolated by slerp
/// out     number of keys that were before 0
/// cost    O(keys)
std::size_t cut_before_zero(SamplerData& data, bool rotation);

}  // namespace sinew
