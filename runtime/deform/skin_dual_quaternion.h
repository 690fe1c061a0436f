// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/base/api.h"
#include "runtime/base/run_job.h"
#include "runtime/deform/influence_streams.h"
#include "runtime/deform/vertex_streams.h"
#include "runtime/deform/vertex_tiles.h"
#include "runtime/pose/joint_palette.h"

namespace sinew {

/// Dual-quaternion skinning in two phases: stretch in bind space, then a rigid motion (Kavan et al. 2008).
/// eq   p1 = sum(w S) p;  d = sum(w sign(r_i . r_pivot) d_i);  d = d / |real(d)|;  p' = d p1 d*
///      n' = rotate(d, normalise(sign(det S) cof(S) n)), S = sum(w S_i)
///      The pivot is the influence with the largest weight, the lowest joint index on ties.
///      Normals stay on the outside even where joints mirror (conventions.h). det S is computed from the rounded
///      entries of S. Its sign is right up to a condition number of S of about 1e6, the limit of float.
/// in   influences   weights sum to 1. If the blend of a vertex is shorter than 1e-6 and its weights sum to less than
///      0.5, they are brought to a sum of 1, so that tiny weights skin as accurately as others. Otherwise S is not
///      divided by the sum of the weights.
///      split[N]     from SplitPaletteJob;   any_stretch  false skips the stretch phase
///      pairs[any]   all distinct (heaviest joint, other joint) pairs of the vertices (joint_pairs_of_vertices). If all
///      pairs are on one hemisphere, signs are not compared per vertex; the bits are the same. Empty = not known.
///      palette[N or none]  the matrices that were split. With it, vertices with one influence are moved by their
///      joint's matrix as in linear blending, in half the time.
///      tiles[1 or none]  of the same vertices (tile_vertices). They skin in about half of the time where all pairs are
///      on one hemisphere, no joint stretches, and the tiles have every attribute that is written. The result is the
///      same up to rounding. A vertex with one influence then leaves out stretches of up to 1e-5, as others do.
/// out  as SkinLinearJob
/// err  size_mismatch, index_out_of_range, unsupported (InfluenceStreams::kMaxConverted)
///      If the real part of a blend cancels (norm^2 < 1e-12), the vertex follows the pivot alone.
/// cost O(V * influences), no allocation
struct SkinDualQuaternionJob {
  InfluenceStreams influences;
  std::span<const RigidStretch> split;
  bool any_stretch = true;
  VertexInput vertices;
  VertexOutput out;
  std::span<const JointPair> pairs;
  std::span<const JointMatrix> palette;
  const VertexTiles* tiles = nullptr;
};

SINEW_API ErrorCode check(const SkinDualQuaternionJob& job) noexcept;
SINEW_API void run_unchecked(const SkinDualQuaternionJob& job) noexcept;

}  // namespace sinew
