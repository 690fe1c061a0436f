// SPDX-License-Identifier: MIT
#include "viewer/passes/shadow_key.h"

#include <algorithm>
#include <bit>

namespace sinew::viewer {
namespace {

void add(const glm::dvec4& row, std::vector<std::uint64_t>& words) {
  for (int i = 0; i < 4; ++i) words.push_back(std::bit_cast<std::uint64_t>(row[i]));
}

void add(const Caster& caster, std::vector<std::uint64_t>& words) {
  const Draw& draw = caster.draw;
  for (const std::uint64_t word :
       {caster.scene, caster.source, caster.since, std::uint64_t{caster.variant}, std::uint64_t{draw.indices_at},
        std::uint64_t{draw.index_count}, std::uint64_t{draw.masked}, std::uint64_t{draw.mirrored}})
    words.push_back(word);
  for (const glm::dvec4& row : caster.world_from_mesh.row) add(row, words);
}

}  // namespace

bool ShadowKey::holds(std::span<const ShadowView> views, std::span<const Caster> casters, VkExtent2D picture) {
  next_.assign({views.size(), picture.width, picture.height});
  for (const ShadowView& view : views)
    for (const glm::dvec4& row : view.map_from_world) add(row, next_);
  for (const Caster& caster : casters) add(caster, next_);
  const bool known = std::none_of(casters.begin(), casters.end(), [](const Caster& c) { return c.since == 0; });
  const bool same = known && next_ == last_;
  last_.swap(next_);
  return same;
}

}  // namespace sinew::viewer
