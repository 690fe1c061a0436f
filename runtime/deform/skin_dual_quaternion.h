// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/base/result.h"
#include "runtime/deform/influence_streams.h"
#include "runtime/deform/vertex_streams.h"
#include "runtime/pose/joint_palette.h"

namespace sinew {

/// Dual-quaternion skinning in two phases: stretch in bind space, then a rigid motion (Kavan et al. 2008).
/// eq   p1 = sum(w S) p;  d = sum(w sign(r_i . r_pivot) d_i), pivot = the influence with the largest weight, lowest
/// index
///      on ties (N17, N18);  d = d / |real(d)|;  p' = d p1 d*;   n' = rotate(d, normalise(sign(det S) cof(S) n)),
///      S = sum(w S_i): to the outside also where joints mirror (conventions.h)
/// in   split[N]        from SplitPaletteJob;   any_stretch  false skips the first phase (P12)
///      pairs[any]      all distinct (heaviest joint, other joint) of the vertices: when each is on one side, signs are
///      not
///                      looked at vertex by vertex; the same bits. Empty: not known
/// out  as SkinLinearJob
/// err  size_mismatch, index_out_of_range, unsupported (InfluenceStreams::kMostWidened)     cost O(V * influences), no
/// allocation;
///      a blend whose real part cancels (norm^2 < 1e-12) follows the pivot alone
struct SkinDualQuaternionJob {
  InfluenceStreams influences;
  std::span<const RigidStretch> split;
  bool any_stretch = true;
  VertexInput vertices;
  VertexOutput out;
  std::span<const JointPair> pairs;
};

ErrorCode check(const SkinDualQuaternionJob& job) noexcept;
void run(const SkinDualQuaternionJob& job) noexcept;

}  // namespace sinew
