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

/// Skinning around optimised centers of rotation. It shows neither the volume loss of linear blending nor the bulge of
/// dual quaternions.
/// eq   p' = R S (p - c) + M c;  M = sum(w J) as in linear blending;  R from the blended rotations, aligned to the
///      hemisphere of the heaviest influence;  S = sum(w S_i), the identity for rigid joints;
///      n' = R normalise(sign(det S) cof(S) n)
///      (Le and Hodgins 2016, algorithm 1; S extends it to scaled joints as in two-phase dual-quaternion skinning)
/// in   palette[N], split[N]  the same joints, from JointPaletteJob and SplitPaletteJob;   any_stretch  false: S = 1
///      centers[V]  in rest space (importer/topology/centers_of_rotation.h). A center equal to the vertex gives linear
///      blending. Vertices with one influence are blended linearly whatever their center is.
///      influences, pairs[any], tiles[1 or none]  as SkinDualQuaternionJob; tiles have the same centers
/// out  as SkinLinearJob
/// err  size_mismatch, index_out_of_range, unsupported (InfluenceStreams::kMaxConverted)
/// cost O(V * influences), no allocation
struct SkinCenterOfRotationJob {
  InfluenceStreams influences;
  std::span<const JointMatrix> palette;
  std::span<const RigidStretch> split;
  bool any_stretch = true;
  std::span<const glm::vec3> centers;
  VertexInput vertices;
  VertexOutput out;
  std::span<const JointPair> pairs;
  const VertexTiles* tiles = nullptr;
};

SINEW_API ErrorCode check(const SkinCenterOfRotationJob& job) noexcept;
SINEW_API void run_unchecked(const SkinCenterOfRotationJob& job) noexcept;

}  // namespace sinew
