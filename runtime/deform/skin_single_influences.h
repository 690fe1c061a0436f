// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/deform/skin_linear.h"

namespace sinew {

/// SkinLinearJob without the rule that groups cover all vertices: only the vertices of its groups are written.
void skin_linear_groups(const SkinLinearJob& job) noexcept;

/// Skins the vertices with one influence by linear blending. Every kind of skinning gives the same positions there: R S
/// p + t = J p. Normals are those of two-phase skinning.
/// in   any_stretch  true: normals are moved by cofactors, since some joint is scaled
inline void skin_single_influences(const InfluenceStreams& influences, std::span<const JointMatrix> palette,
                                   bool any_stretch, const VertexInput& in, const VertexOutput& out) noexcept {
  for (const InfluenceGroup& group : influences.groups)
    if (group.influence_count == 1)
      skin_linear_groups(SkinLinearJob{InfluenceStreams({&group, 1}, influences.joints, influences.weights), palette,
                                       in, out, any_stretch ? NormalRule::cofactor : NormalRule::linear});
}

}  // namespace sinew
