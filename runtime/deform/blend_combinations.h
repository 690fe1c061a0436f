// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/base/run_job.h"
#include "runtime/math/joint_matrix.h"
#include "runtime/model/skin.h"

namespace sinew {

/// Blended matrices of combinations of joints and weights. Vertices that share a combination then follow one matrix,
/// with the bits that SkinLinearJob would blend for each of them (C06).
/// eq   M = sum(w_i * palette[joint_i])   (Real-Time Rendering, 4th ed., eq. 4.59)
/// in   combinations  influences, one combination in place of each vertex;   palette[N]
/// out  blended[combinations]  may follow the palette in memory; must not overlap it
/// err  size_mismatch, index_out_of_range     cost O(influences of the combinations), no allocation
struct BlendCombinationsJob {
  const VertexInfluences* combinations = nullptr;
  std::span<const JointMatrix> palette;
  std::span<JointMatrix> blended;
};

ErrorCode check(const BlendCombinationsJob& job) noexcept;
void run_unchecked(const BlendCombinationsJob& job) noexcept;

}  // namespace sinew
