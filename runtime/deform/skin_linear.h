// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/base/run_job.h"
#include "runtime/deform/influence_streams.h"
#include "runtime/deform/vertex_streams.h"
#include "runtime/math/joint_matrix.h"

namespace sinew {

/// How normals follow the blended matrix M. `linear`: normalise(mat3(M) n), as shaders of engines do; right where the
/// blend is rigid or uniformly scaled. `cofactor`: normalise(sign(det M) cof(mat3(M)) n), right under any scale,
/// without division (N22). Both keep to the outside where M mirrors; the sign is exact for every M (conventions.h).
enum class NormalRule : unsigned char { linear, cofactor };

/// Linear-blend skinning.
/// eq   M = sum(w_i * palette[joint_i]),  p' = M p   (Real-Time Rendering, 4th ed., eq. 4.59);  t' =
///      normalise(mat3(M) t)
/// in   influences  groups cover [0, V); weights sum to 1;   palette[N]
/// out  vertices    must not overlap the input; in world space when the palette is. A normal that collapses to zero
///      keeps its input value (N22).
/// err  size_mismatch, index_out_of_range, unsupported (InfluenceStreams::kMostWidened)
/// cost O(V * influences), no allocation. Outputs of 8 MiB and more, and those with `past_caches` where vectors have 8
///      lanes, are written with non-temporal stores where all attributes are aligned to 64 bytes at the same vertices.
///      Slower where input and output have nearly the same
///      address modulo 4096: loads then wait for stores. With `cofactor`, vertices whose matrix is nearly flat take
///      the scalar path, which is many times slower.
struct SkinLinearJob {
  InfluenceStreams influences;
  std::span<const JointMatrix> palette;
  VertexInput vertices;
  VertexOutput out;
  NormalRule normal_rule = NormalRule::linear;
  bool past_caches = false;  ///< nothing on this processor reads the output soon
};

ErrorCode check(const SkinLinearJob& job) noexcept;
void run_unchecked(const SkinLinearJob& job) noexcept;

}  // namespace sinew
