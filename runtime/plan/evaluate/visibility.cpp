// SPDX-License-Identifier: MIT
#include "runtime/plan/evaluate/visibility.h"

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

std::span<const bool> wanted_palettes(const CompiledPlan& plan, const Visibility& visibility,
                                      std::span<const GeometryInput> geometry, std::span<const ShownVertices> shown,
                                      FrameMemory memory) noexcept {
  const auto plays_in_full = [&](std::size_t i) {
    const std::uint32_t slot = geometry.empty() || plan.needs.out.palettes ? kNone : geometry_slot_of(plan, i);
    return slot != kNone && geometry[slot].weight == 1.0f && shown[slot].is_there;
  };
  const std::span<bool> wanted = memory.of(plan.layout.palette_wanted);
  std::fill(wanted.begin(), wanted.end(), false);
  for (std::size_t i = 0; i < plan.scene->instances.size(); ++i)
    if (const std::uint32_t skin = plan.scene->instances[i].skin; skin != kNone)
      wanted[skin] = wanted[skin] || (visibility.is_deformed(plan, i) && !plays_in_full(i));
  return wanted;
}

}  // namespace sinew
