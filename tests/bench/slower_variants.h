// SPDX-License-Identifier: MIT
#pragma once
#include <span>

#include "runtime/deform/scalar_blend.h"
#include "runtime/deform/vertex_streams.h"

/// Slower variants, kept so that they are measured beside the version in use.
namespace sinew::bench {

/// Skins one vertex after the other, as the scalar target does. This is slower: the compiler fills four lanes of
/// sixteen, and each normal takes a division.
inline void vertexwise_linear(const VertexInfluences& influences, std::span<const JointMatrix> palette,
                              const VertexInput& in, const VertexOutput& out) {
  for_each_vertex(influences, [&](std::size_t v, const auto& joints) {
    const Affine m = blend_matrix(palette, joints);
    out.positions[v] = transform_point(m, in.positions[v]);
    out.normals[v] = normalised_or(transform_vector(m, in.normals[v]), in.normals[v]);
  });
}

/// Same with dual quaternions. It is slower by as much: rotation and normalisation of one vertex fill few lanes.
inline void vertexwise_dual_quaternion(const VertexInfluences& influences, std::span<const RigidStretch> split,
                                       const VertexInput& in, const VertexOutput& out) {
  for_each_vertex(influences, [&](std::size_t v, const auto& joints) {
    const DualQuat motion = blend_dual_quaternion(split, joints);
    out.positions[v] = transform_point(motion, in.positions[v]);
    out.normals[v] = normalised_or(transform_vector(motion, in.normals[v]), in.normals[v]);
  });
}

}  // namespace sinew::bench
