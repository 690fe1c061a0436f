// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/animation/skeleton.h"

namespace sinew {

/// Tells whether two skeletons are the same for clips: the same joints, by name, in the same order, under the same
/// parents. Compiled clips name joints by index, so they play on every skeleton of their signature, and on no other.
/// The rest pose is no part of it: bodies of other sizes share their clips, and a clip carries the rest pose that it
/// was compiled with. Node indices are none either, since each file numbers its nodes as it likes. The value is stored
/// in files. It is the same on every machine and in every version.
/// eq   checksum (base/checksum.h) of 32-bit little-endian numbers and bytes: the number of joints, then of each joint
///      its parent (2^32 - 1 for a root), the length of its name, and its name
/// cost O(bytes of names + joints), allocates as much for a moment
std::uint64_t skeleton_signature(const Skeleton& skeleton);

}  // namespace sinew
