// SPDX-License-Identifier: MIT
#include "runtime/c/plan.h"

#include "runtime/c/glue/call.h"
#include "runtime/c/glue/convert.h"
#include "runtime/c/glue/struct_versions.h"
#include "runtime/c/needs.h"

using namespace sinew;

sinew_error sinew_plan_create(const sinew_scene* scene, const sinew_needs* needs, sinew_plan** out) {
  return c::call(c::given(scene, out), [&] {
    Needs wanted;
    if (const sinew_error error = c::read_needs(needs, scene->scene, wanted)) return error;
    *out = new sinew_plan(*scene, scene->scene.clips, wanted);
    return SINEW_OK;
  });
}

void sinew_plan_destroy(sinew_plan* plan) { delete plan; }

std::uint32_t sinew_pose_joint(const sinew_plan* plan, std::uint32_t joint) {
  if (plan == nullptr || joint >= plan->scene->scene.skeleton.joint_count()) return SINEW_NONE;
  return pose_joint(plan->plan, joint);
}

std::size_t sinew_stage_count(const sinew_plan* plan) { return plan != nullptr ? plan->stages.size() : 0; }

sinew_error sinew_get_stage(const sinew_plan* plan, std::uint32_t stage, sinew_stage* out) {
  return c::call(c::given(plan), [&] {
    if (stage >= plan->stages.size()) return SINEW_INDEX_OUT_OF_RANGE;
    const PlanStage& found = plan->stages[stage];
    return c::write_struct({.struct_size = 0,
                            .name = c::to_c(found.stage),
                            .reason = c::to_c(found.reason),
                            .count = found.count,
                            .bytes = found.bytes,
                            .runs = found.runs},
                           out);
  });
}
