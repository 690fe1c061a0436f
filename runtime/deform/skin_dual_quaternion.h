// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/base/run_job.h"
#include "runtime/deform/influence_streams.h"
#include "runtime/deform/vertex_streams.h"
#include "runtime/pose/joint_palette.h"

namespace sinew {

/// Dual-quaternion skinning in two phases: stretch in bind space, then a rigid motion (Kavan et al. 2008).
/// eq   p1 = sum(w S) p;  d = sum(w sign(r_i . r_pivot) d_i), pivot = the influence with the largest weight, lowest
///      index on ties (N17, N18);  d = d / |real(d)|;  p' = d p1 d*;   n' = rotate(d, normalise(sign(det S) cof(S)
///      n)), S = sum(w S_i): to the outside also where joints mirror (conventions.h). The side is that of the entries
///      of S: it is that of the joints up to a condition of about 1e6 of S, which rounding to float limits.
/// in   influences   weights sum to 1. Where the blend of a vertex is shorter than 1e-6, weights that sum to less
///      than 0.5 are brought to a sum of 1: tiny weights in proportion skin as accurately as others. Between these
///      limits S is not divided by the sum.
///      split[N]     from SplitPaletteJob;   any_stretch  false skips the first phase (P12)
///      pairs[any]   all distinct (heaviest joint, other joint) of the vertices. Where all are on one hemisphere,
///      signs are not compared vertex by vertex; the bits are the same. Empty: not known
///      palette[N or none]  the matrices that were split. Vertices with one influence are then moved by their joint's
///      matrix, as linear blending does, for half the time
/// out  as SkinLinearJob
/// err  size_mismatch, index_out_of_range, unsupported (InfluenceStreams::kMostWidened)
///      A blend whose real part cancels (norm^2 < 1e-12) follows the pivot alone.
/// cost O(V * influences), no allocation
struct SkinDualQuaternionJob {
  InfluenceStreams influences;
  std::span<const RigidStretch> split;
  bool any_stretch = true;
  VertexInput vertices;
  VertexOutput out;
  std::span<const JointPair> pairs;
  std::span<const JointMatrix> palette;
};

ErrorCode check(const SkinDualQuaternionJob& job) noexcept;
void run_unchecked(const SkinDualQuaternionJob& job) noexcept;

}  // namespace sinew
