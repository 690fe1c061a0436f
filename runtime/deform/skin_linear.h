// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/base/result.h"
#include "runtime/deform/influence_streams.h"
#include "runtime/deform/vertex_streams.h"
#include "runtime/math/joint_matrix.h"

namespace sinew {

/// How normals follow the blended matrix M. `linear`: normalise(mat3(M) n), what engines' shaders compute; right when
/// the blend is rigid or uniformly scaled. `cofactor`: normalise(sign(det) cof(mat3(M)) n), right under any scale, no
/// division (N22). Both keep to the outside where M mirrors (conventions.h).
enum class NormalRule : unsigned char { linear, cofactor };

/// Linear-blend skinning.
/// eq   M = sum(w_i * palette[joint_i]),  p' = M p   (Real-Time Rendering, 4th ed., eq. 4.59);  t' = normalise(mat3(M)
/// t) in   influences  groups cover [0, V); weights sum to 1;   palette[N] out  vertices    must not overlap the input;
/// world space when the palette is; a normal that collapses to zero keeps its input value (N22) err  size_mismatch,
/// index_out_of_range, unsupported (InfluenceStreams::kMostWidened)     cost O(V * influences), no allocation;
///      from 8 MiB on output is written past the caches, if its attributes are aligned to 64 bytes at the same
///      vertices; slower where inputs and outputs have nearly the same address modulo 4096: loads then wait for stores
struct SkinLinearJob {
  InfluenceStreams influences;
  std::span<const JointMatrix> palette;
  VertexInput vertices;
  VertexOutput out;
  NormalRule normal_rule = NormalRule::linear;
};

ErrorCode check(const SkinLinearJob& job) noexcept;
void run(const SkinLinearJob& job) noexcept;

}  // namespace sinew
