// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/deform/skin_linear.h"

namespace sinew {

/// SkinLinearJob for the vertices of its groups alone; a checked job has groups for all vertices.
void skin_linear_groups(const SkinLinearJob& job) noexcept;

/// Vertices with one influence move with their joint: R S p + t = J p, for every kind of skinning. Linear blending of
/// one matrix does them, with the normals of the two-phase kinds.
/// in   any_stretch  normals need cofactors
inline void skin_single_influences(const InfluenceStreams& influences, std::span<const JointMatrix> palette,
                                   bool any_stretch, const VertexInput& in, const VertexOutput& out) noexcept {
  for (const InfluenceGroup& group : influences.groups)
    if (group.influence_count == 1)
      skin_linear_groups(SkinLinearJob{InfluenceStreams({&group, 1}, influences.joints, influences.weights), palette,
                                       in, out, any_stretch ? NormalRule::cofactor : NormalRule::linear});
}

}  // namespace sinew
