// SPDX-License-Identifier: MIT
#include "runtime/plan/find_hidden.h"

#include <algorithm>

namespace sinew {

void find_hidden(const Scene& scene, std::span<const float> properties, std::span<bool> hidden) noexcept {
  std::fill(hidden.begin(), hidden.end(), false);
  for (const std::uint32_t joint : scene.hidden_joints) hidden[joint] = true;
  if (!properties.empty())
    for (const PropertyTable::Entry& entry : scene.properties.entries)
      if (entry.target.kind == PropertyKind::node_visible)
        hidden[entry.target.index] = !(properties[entry.first] >= 0.5f);
  const auto& parents = scene.skeleton.parents;
  for (std::size_t j = 0; j < hidden.size(); ++j)
    if (parents[j] != kNone && hidden[parents[j]]) hidden[j] = true;
}

}  // namespace sinew
