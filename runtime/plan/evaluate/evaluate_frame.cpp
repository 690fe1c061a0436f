// SPDX-License-Identifier: MIT
#include "runtime/plan/evaluate/evaluate_frame.h"

#include <cassert>

#include "runtime/plan/evaluate/evaluate_pose.h"
#include "runtime/plan/evaluate/frame_step.h"
#include "runtime/plan/evaluate/interpolate_poses.h"
#include "runtime/plan/evaluate/make_palettes.h"
#include "runtime/plan/evaluate/play_geometry.h"
#include "runtime/plan/evaluate/show_instances.h"
#include "runtime/plan/evaluate/visibility.h"
#include "runtime/plan/playing_layers.h"
#include "runtime/pose/correct_pose.h"
#include "runtime/pose/local_to_model.h"

namespace sinew {
namespace {

/// Stage correctives: adds to the frame's morph weights.
/// out  [W] the weights of the frame
std::span<const float> correct_weights(const CompiledPlan& plan, const PoseSpan& local, FrameMemory memory,
                                       FrameWork& work) noexcept {
  const std::span<float> weights = memory.of(plan.layout.pose.weights);
  if (!plan.correctives) return weights;
  for (const PoseCorrective& corrective : plan.assets.correctives) {
    const CorrectPoseJob job{.corrective = &corrective,
                             .pose = local,
                             .scratch = memory.of(plan.layout.corrective_scratch),
                             .weights = weights};
    assert(check(job) == ErrorCode::ok);
    run_unchecked(job);
    work.poses_compared += corrective.samples.sample_count();
  }
  work.spent_on(Stage::correctives);
  return weights;
}

/// Sets joints that no clip moves to the rest pose, to the last bit, since a mean of layers rounds them. Writes the
/// frame's own pose, since `local` may be a pose that is kept for later frames.
PoseSpan with_unmoved_at_rest(const CompiledPlan& plan, const PoseSpan& local, FrameMemory memory) noexcept {
  const PoseSpan rest = memory.of(plan.layout.rest_pose), own = memory.of(plan.layout.pose.pose);
  if (local.planes != own.planes) copy_pose(local, own);
  std::size_t next = 0;
  for (std::size_t j = 0; j < own.joint_count; ++j) {
    if (next < plan.moved_joints.size() && plan.moved_joints[next] == j)
      ++next;
    else
      own.set(j, rest.get(j));
  }
  return own;
}

/// A mean of several poses rounds joints that rest.
bool mixes_poses(const CompiledPlan& plan, const FrameInput& input) noexcept {
  return plan.sample && (input.interpolation_factor != 0.0f || !plays_alone(input.layers));
}

/// Stage local_to_model: the world matrices of all joints. Empty where the plan leaves them out.
std::span<const Affine> compose(const CompiledPlan& plan, const PoseSpan& local, const FrameInput& input,
                                const FrameStep& step, FrameWork& work) noexcept {
  if (!plan.local_to_model) return {};
  const std::span<Affine> model = step.memory.of(plan.layout.model);
  const StandingMatrices stand = step.reuse.stands().matrices;
  if (stand == StandingMatrices::all) return model;
  LocalToModelJob job{.skeleton = plan.assets.skeleton, .local = local, .root = input.root, .model = model};
  if (stand == StandingMatrices::of_unmoved_joints)
    job.only = plan.moved_joints;
  else if (mixes_poses(plan, input))
    job.local = with_unmoved_at_rest(plan, local, step.memory);
  assert(check(job) == ErrorCode::ok);
  run_unchecked(job);
  work.joints_composed += job.only.empty() ? model.size() : job.only.size();
  work.spent_on(Stage::local_to_model);
  return model;
}

/// The hidden joints; empty when the plan hides nothing. Without animated flags the frame buffer found them once for
/// all frames.
std::span<const bool> hide(const CompiledPlan& plan, std::span<const float> properties, FrameMemory memory,
                           FrameWork& work) noexcept {
  if (!plan.hide) return {};
  const std::span<bool> hidden = memory.of(plan.layout.hidden);
  if (plan.hide_per_frame && plan.properties) {
    find_hidden(*plan.scene, properties, hidden);
    work.spent_on(Stage::properties);
  }
  return hidden;
}

void show_tables(const CompiledPlan& plan, const FrameTables& tables, FrameResult& result) noexcept {
  if (plan.needs.out.palettes) result.palettes = tables.palettes;
  result.instances = tables.instances;
  result.primitives = tables.primitives;
  result.stage_ns = tables.stage_ns;
}

void sleep(const CompiledPlan& plan, const Reuse& reuse, FrameResult& result) noexcept {
  reuse.forget_all();
  hide_instances(plan, reuse.tables());
  result.model = {};
  result.weights = {};
  result.properties = {};
  result.hidden = {};
  show_tables(plan, reuse.tables(), result);
  result.work = FrameWork(reuse.tables().stage_ns).counters();
}

/// All stages in the order in which they run.
void run_stages(const CompiledPlan& plan, const FrameInput& input, const FrameStep& step,
                FrameResult& result) noexcept {
  const FrameMemory memory = step.memory;
  FrameWork work(step.tables.stage_ns);
  const PoseSpan local =
      plan.interpolate ? interpolate_poses(plan, input, step, work)
                       : evaluate_pose(plan, input.layers, input.weights, memory, step.reuse.stands().base_pose, work);
  const std::span<const float> weights = correct_weights(plan, local, memory, work);
  const std::span<const Affine> model = compose(plan, local, input, step, work);
  const std::span<const float> properties = memory.of(plan.layout.pose.properties);
  const Visibility visibility{hide(plan, properties, memory, work), input.out_of_view};
  show_sources(plan, input.geometry, visibility, step.tables, work);
  const bool all_wanted = !plan.hide_per_frame && input.out_of_view.empty() && input.geometry.empty();
  const std::span<const bool> wanted =
      all_wanted ? std::span<const bool>{}
                 : wanted_palettes(plan, visibility, input.geometry, step.tables.shown, memory);
  make_palettes(plan, model, wanted, step, work);
  show_instances(plan, {model, weights, input.root, visibility, input.geometry}, step, work);
  result.model = plan.needs.out.joints ? model : std::span<const Affine>{};
  result.weights = weights;
  result.properties = plan.needs.out.properties ? properties : std::span<const float>{};
  result.hidden = visibility.hidden;
  show_tables(plan, step.tables, result);
  result.work = work.counters();
}

}  // namespace

void evaluate_frame(const CompiledPlan& plan, const FrameInput& input, FrameMemory memory, const Reuse& reuse,
                    bool past_caches, FrameResult& result) noexcept {
  if (reuse.stands().all) {
    reuse.keep_all();
    result.work = FrameWork(reuse.tables().stage_ns).counters();
  } else if (input.asleep) {
    sleep(plan, reuse, result);
  } else {
    run_stages(plan, input, {memory, reuse, reuse.tables(), past_caches}, result);
  }
}

}  // namespace sinew
