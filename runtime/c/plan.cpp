// SPDX-License-Identifier: MIT
#include "runtime/c/plan.h"

#include <cmath>
#include <memory>

#include "runtime/c/boundary.h"
#include "runtime/c/handles.h"

namespace {

using namespace sinew;

constexpr std::uint32_t kAllFlags = (SINEW_NEED_PALETTES << 1) - 1;

static_assert(static_cast<int>(Skinning::linear) == SINEW_SKIN_LINEAR &&
              static_cast<int>(Skinning::dual_quaternion) == SINEW_SKIN_DUAL_QUATERNION &&
              static_cast<int>(Skinning::center_of_rotation) == SINEW_SKIN_CENTER_OF_ROTATION &&
              static_cast<int>(NormalRule::cofactor) == SINEW_NORMALS_COFACTOR);

sinew_error check(const sinew_needs& given, std::size_t joints, std::size_t instances) noexcept {
  if ((given.flags & ~kAllFlags) != 0 || given.max_layers == 0) return SINEW_UNSUPPORTED;
  if (given.skinning > SINEW_SKIN_CENTER_OF_ROTATION || given.normal_rule > SINEW_NORMALS_COFACTOR)
    return SINEW_UNSUPPORTED;
  if (given.mask_count > 0 && given.masks == nullptr) return SINEW_NULL_ARGUMENT;
  for (std::size_t i = 0; i < given.mask_count * joints; ++i)
    if (!std::isfinite(given.masks[i]) || given.masks[i] < 0.0f) return SINEW_NOT_FINITE;
  for (std::size_t i = 0; given.instance_skinning != nullptr && i < instances; ++i)
    if (given.instance_skinning[i] > SINEW_SKIN_CENTER_OF_ROTATION) return SINEW_UNSUPPORTED;
  return SINEW_OK;
}

Needs needs_from(const sinew_needs& given, std::size_t joints, std::size_t instances) {
  const auto asked = [&](std::uint32_t flag) { return (given.flags & flag) != 0; };
  Needs needs;
  needs.joints = asked(SINEW_NEED_JOINTS), needs.positions = asked(SINEW_NEED_POSITIONS);
  needs.normals = asked(SINEW_NEED_NORMALS), needs.tangents = asked(SINEW_NEED_TANGENTS);
  needs.weights = asked(SINEW_NEED_WEIGHTS), needs.bounds = asked(SINEW_NEED_BOUNDS);
  needs.properties = asked(SINEW_NEED_PROPERTIES), needs.hidden_meshes = asked(SINEW_NEED_HIDDEN_MESHES);
  needs.additive = asked(SINEW_NEED_ADDITIVE), needs.palettes = asked(SINEW_NEED_PALETTES);
  needs.max_layers = given.max_layers;
  needs.skinning = static_cast<Skinning>(given.skinning);
  needs.normal_rule = static_cast<NormalRule>(given.normal_rule);
  for (std::size_t m = 0; m < given.mask_count; ++m)
    needs.masks.emplace_back(given.masks + m * joints, given.masks + (m + 1) * joints);
  for (std::size_t i = 0; given.instance_skinning != nullptr && i < instances; ++i)
    needs.instance_skinning.push_back(static_cast<Skinning>(given.instance_skinning[i]));
  return needs;
}

}  // namespace

sinew_needs sinew_default_needs(void) {
  return {.struct_size = sizeof(sinew_needs),
          .flags = SINEW_NEED_JOINTS | SINEW_NEED_POSITIONS | SINEW_NEED_NORMALS | SINEW_NEED_TANGENTS |
                   SINEW_NEED_WEIGHTS | SINEW_NEED_PROPERTIES,
          .max_layers = 4,
          .max_adding_layers = 4,
          .skinning = SINEW_SKIN_LINEAR,
          .normal_rule = SINEW_NORMALS_LINEAR,
          .mask_count = 0,
          .masks = nullptr,
          .instance_skinning = nullptr};
}

sinew_error sinew_plan_create(const sinew_scene* scene, const sinew_needs* needs, sinew_plan** out) {
  if (scene == nullptr || out == nullptr) return SINEW_NULL_ARGUMENT;
  sinew_needs given = sinew_default_needs();
  if (const sinew_error error = c::read_struct(needs, given); error != SINEW_OK) return error;
  const std::size_t joints = scene->scene.skeleton.joint_count(), instances = scene->scene.instances.size();
  if (const sinew_error error = check(given, joints, instances); error != SINEW_OK) return error;
  return c::guarded([&] {
    const Needs wanted = needs_from(given, joints, instances);
    *out = new sinew_plan{compile_plan(scene->scene, wanted), wanted.additive ? given.max_adding_layers : 0};
    return SINEW_OK;
  });
}

void sinew_plan_destroy(sinew_plan* plan) { delete plan; }

std::size_t sinew_stage_count(const sinew_plan* plan) { return plan->plan.stages.size(); }

sinew_error sinew_get_stage(const sinew_plan* plan, std::uint32_t stage, sinew_stage* out) {
  if (plan == nullptr) return SINEW_NULL_ARGUMENT;
  if (stage >= plan->plan.stages.size()) return SINEW_INDEX_OUT_OF_RANGE;
  const PlanStage& found = plan->plan.stages[stage];
  return c::write_struct({.struct_size = 0,
                          .name = c::string_from(found.stage),
                          .reason = c::string_from(found.reason),
                          .count = found.count,
                          .bytes = found.bytes,
                          .runs = found.runs},
                         out);
}
