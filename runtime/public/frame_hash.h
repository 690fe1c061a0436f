// SPDX-License-Identifier: MIT
#pragma once
/// Equality to the last bit: hashes of what a frame shows, for golden files and replays, and same_bits for arrays.
///
///     const std::uint64_t pose = hash_pose(frame.result()), vertices = hash_vertices(frame.result());
#include "runtime/base/bit_hash.h"
#include "runtime/base/same_bits.h"
#include "runtime/plan/frame_hash.h"
