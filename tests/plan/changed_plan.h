// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <utility>

#include "runtime/plan/compiled_plan.h"

namespace sinew::test {

/// A copy of the plan that `change(CompiledPlan&)` has edited.
template <class Change>
Plan changed(const Plan& plan, const Change& change) {
  auto copy = std::make_shared<CompiledPlan>(*plan.compiled());
  change(*copy);
  return Plan(std::move(copy));
}

/// A copy of the plan without shared blended matrices: every vertex blends its own.
inline Plan without_combinations(const Plan& plan) {
  return changed(plan, [](CompiledPlan& copy) {
    for (std::vector<CombinedInfluences>& of_skin : copy.combined) of_skin.clear();
    for (PrimitiveSkinning& skinning : copy.primitive_skinning) {
      if (skinning.combined != kNone) {
        skinning.tiles = nullptr;
        skinning.morphs = nullptr;
      }
      skinning.combined = kNone;
    }
    copy.layout = {};
    lay_out_frame(copy);
  });
}

/// A copy of the plan whose vertices keep the order of the mesh.
inline Plan without_tiles(const Plan& plan) {
  return changed(plan, [](CompiledPlan& copy) {
    for (PrimitiveSkinning& skinning : copy.primitive_skinning) {
      skinning.tiles = nullptr;
      skinning.morphs = nullptr;
    }
    copy.layout = {};
    lay_out_frame(copy);
  });
}

}  // namespace sinew::test
