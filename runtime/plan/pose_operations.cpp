// SPDX-License-Identifier: MIT
#include "runtime/plan/pose_operations.h"

#include <algorithm>

namespace sinew {
PoseProgramAssets pose_assets(const CompiledPlan& plan) noexcept {
  PoseProgramAssets assets;
  assets.skeleton = plan.assets.skeleton;
  assets.clips = plan.assets.clips;
  assets.rest_weights = plan.rest_weights;
  if (plan.properties) assets.rest_properties = plan.scene->properties.rest;
  assets.masks = plan.masks;
  if (plan.mirror) {
    assets.mirror = &plan.mirror_tables;
    assets.mirrored_weight_source = plan.assets.mirror->weight_source;
  }
  assets.clip_tracks = plan.clip_tracks;
  return assets;
}

PoseProgramRoom pose_room(const CompiledPlan& plan) noexcept {
  const std::uint32_t blended = plan.blend ? plan.needs.in.max_layers : 1;
  const std::uint32_t with_added = plan.add ? 3 : 1;  // the pose, a layer, its reference
  return larger({.slots = std::max(blended, with_added)}, plan.needs.in.program);
}

PoseProgramLimits program_limits(const CompiledPlan& plan, const PoseProgramInputs& inputs) noexcept {
  return {.clips = std::min<std::size_t>(plan.assets.clips.size(), kMostClipsOfPrograms),
          .externals = inputs.externals.size(),
          .masks = plan.masks.size() + inputs.masks.size(),
          .overrides = inputs.overrides.size(),
          .procedures = inputs.procedures.size(),
          .mirror = plan.mirror,
          .slots = plan.needs.in.program.slots,
          .kept = plan.needs.in.program.kept,
          .overlays_in_model_space = plan.needs.in.program.overlays_in_model_space};
}

}  // namespace sinew
