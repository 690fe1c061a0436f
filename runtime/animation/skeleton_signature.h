// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/animation/skeleton.h"

namespace sinew {

/// Equal for skeletons that can share compiled clips: the same joint names, in the same order, with the same parents.
/// Compiled clips refer to joints by index, so they play only on skeletons with their signature. The rest pose does
/// not count, so bodies of other sizes share clips: a clip contains the rest pose that it was compiled with. The
/// signature is stored in files, and is the same on every machine and in every version.
/// eq   checksum (base/checksum.h) of 32-bit little-endian numbers and bytes: the number of joints, then of each joint
///      its parent (2^32 - 1 for a root), the length of its name, and its name
/// cost O(bytes of names + joints), allocates temporary memory of that size
std::uint64_t skeleton_signature(const Skeleton& skeleton);

}  // namespace sinew
