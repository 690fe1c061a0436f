// SPDX-License-Identifier: MIT
#include "runtime/deform/morph_colors.h"

#include <algorithm>

#include <glm/common.hpp>

#include "runtime/deform/morph_vertices.h"

namespace sinew {

void morph_colors(const MorphSet& morphs, std::span<const float> weights, std::span<const glm::vec4> colors,
                  std::span<glm::vec4> out) noexcept {
  std::fill(out.begin(), out.end(), glm::vec4(0.0f));
  for (std::size_t t = 0; t < morphs.targets.size(); ++t) {
    if (!is_active_weight(weights[t])) continue;
    const SparseDeltas<glm::vec4>& moved = morphs.targets[t].colors;
    for (std::size_t i = 0; i < moved.vertices.size(); ++i) out[moved.vertices[i]] += weights[t] * moved.deltas[i];
  }
  for (std::size_t v = 0; v < out.size(); ++v) out[v] = glm::clamp(colors[v] + out[v], 0.0f, 1.0f);
}

}  // namespace sinew
