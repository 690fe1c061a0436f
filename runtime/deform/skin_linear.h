// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/base/api.h"
#include "runtime/base/run_job.h"
#include "runtime/deform/influence_streams.h"
#include "runtime/deform/vertex_streams.h"
#include "runtime/math/joint_matrix.h"

namespace sinew {

/// How normals follow the blended matrix M. `linear`: normalise(mat3(M) n), as most engines' shaders do. It is right
/// for rigid and uniformly scaled blends. `cofactor`: normalise(sign(det M) cof(mat3(M)) n). It is right for any scale
/// and does not divide. Both keep normals on the outside where M mirrors; the sign is exact for every M
/// (conventions.h).
enum class NormalRule : unsigned char { linear, cofactor };

/// Linear-blend skinning.
/// eq   M = sum(w_i * palette[joint_i]),  p' = M p   (Real-Time Rendering, 4th ed., eq. 4.59)
///      t' = normalise(mat3(M) t)
/// in   influences  groups cover [0, V); weights sum to 1;   palette[N]
/// out  vertices    must not overlap the input; in world space when the palette is. A normal that collapses to zero
///      keeps its input value.
/// err  size_mismatch, index_out_of_range, unsupported (InfluenceStreams::kMaxConverted)
/// cost O(V * influences), no allocation. Outputs of 8 MiB and more are written by non-temporal stores. With
///      `past_caches` all outputs are, on machines whose vectors have 8 lanes or more. These stores need all attributes
///      aligned to 64 bytes at the same vertices.
///      Slower if input and output have nearly the same address modulo 4096: loads then wait for stores.
///      With `cofactor`, vertices whose matrix is nearly flat take the scalar path, which is many times slower.
struct SkinLinearJob {
  InfluenceStreams influences;
  std::span<const JointMatrix> palette;
  VertexInput vertices;
  VertexOutput out;
  NormalRule normal_rule = NormalRule::linear;
  bool past_caches = false;  ///< a hint that this processor will not read the output soon, so it may bypass the caches
};

SINEW_API ErrorCode check(const SkinLinearJob& job) noexcept;
SINEW_API void run_unchecked(const SkinLinearJob& job) noexcept;

}  // namespace sinew
