// SPDX-License-Identifier: MIT
#include "importer/vrm_expressions.h"

#include <cstddef>
#include <cstdint>
#include <utility>

namespace sinew {
namespace {

Expression::Override override_from(VrmExpression::Override from) noexcept {
  using From = VrmExpression::Override;
  using To = Expression::Override;
  return from == From::block ? To::block : from == From::blend ? To::blend : To::none;
}

}  // namespace

std::vector<Expression> expressions_of(const VrmCharacter& vrm, const Scene& scene) {
  std::vector<Expression> out;
  for (const VrmExpression& from : vrm.expressions) {
    Expression to;
    to.name = from.name;
    to.is_binary = from.is_binary;
    if (from.is_preset) to.part = part_of_preset(from.name);
    to.blink = override_from(from.override_blink);
    to.look_at = override_from(from.override_look_at);
    to.mouth = override_from(from.override_mouth);
    for (const VrmMorphBind& bind : from.morphs) {
      if (std::size_t{bind.instance} + 1 >= scene.first_weight.size()) continue;
      const std::uint32_t first = scene.first_weight[bind.instance], end = scene.first_weight[bind.instance + 1];
      if (bind.target < end - first) to.binds.push_back({first + bind.target, bind.weight});
    }
    out.push_back(std::move(to));
  }
  return out;
}

}  // namespace sinew
