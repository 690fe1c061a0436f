// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/deform/scalar_blend.h"
#include "runtime/deform/vertex_streams.h"

/// Variants that lost, kept so that they are measured beside the winner.
namespace sinew::bench {

/// One vertex after the other, as the scalar target does. It lost because the compiler fills four lanes of sixteen and
/// divides once per normal.
inline void vertexwise_linear(const VertexInfluences& influences, std::span<const JointMatrix> palette,
                              const VertexInput& in, const VertexOutput& out) {
  for_each_vertex(influences, [&](std::size_t v, const auto& joints) {
    const Affine m = blend_matrix(palette, joints);
    out.positions[v] = transform_point(m, in.positions[v]);
    out.normals[v] = normalised_or(transform_vector(m, in.normals[v]), in.normals[v]);
  });
}

/// The same with dual quaternions. It lost by as much: rotation and normalisation of one vertex fill no lanes.
inline void vertexwise_dual_quaternion(const VertexInfluences& influences, std::span<const RigidStretch> split,
                                       const VertexInput& in, const VertexOutput& out) {
  for_each_vertex(influences, [&](std::size_t v, const auto& joints) {
    const DualQuat motion = blend_dual_quaternion(split, joints);
    out.positions[v] = transform_point(motion, in.positions[v]);
    out.normals[v] = normalised_or(transform_vector(motion, in.normals[v]), in.normals[v]);
  });
}

}  // namespace sinew::bench
