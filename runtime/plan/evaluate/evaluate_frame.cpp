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

/// True if poses are mixed, which rounds joints that should stay exactly at rest.
bool mixes_poses(const CompiledPlan& plan, const FrameInput& input) noexcept {
  return plan.poses && (!input.program.empty() || input.interpolation_factor != 0.0f || !plays_alone(input.layers));
}

/// Sets joints that nothing moves to the bits of the rest pose. It writes the frame's own pose, since `local` may be a
/// pose that later frames use.
PoseSpan with_unmoved_at_rest(const CompiledPlan& plan, const PoseSpan& local, FrameMemory memory) noexcept {
  if (plan.unmoved_joints.empty()) return local;
  const PoseSpan rest = memory.of(plan.layout.rest_pose), own = memory.of(plan.layout.pose.pose);
  if (local.planes != own.planes) copy_pose(local, own);
  for (const std::uint32_t joint : plan.unmoved_joints) own.set(joint, rest.get(joint));
  return own;
}

/// Stage local_to_model: the world matrices of all joints. Empty if the plan needs none.
std::span<const Affine> compose(const CompiledPlan& plan, const PoseSpan& local, const FrameInput& input,
                                const FrameStep& step, FrameWork& work) noexcept {
  if (!plan.local_to_model) return {};
  const std::span<Affine> model = step.memory.of(plan.layout.model);
  const StandingMatrices stand = step.reuse.stands().matrices;
  if (stand == StandingMatrices::all) return model;
  LocalToModelJob job{.skeleton = plan.assets.skeleton, .local = local, .root = input.root, .model = model};
  if (stand == StandingMatrices::of_unmoved_joints) job.only = plan.moved_joints;
  assert(check(job) == ErrorCode::ok);
  run_unchecked(job);
  work.joints_composed += job.only.empty() ? model.size() : job.only.size();
  work.spent_on(Stage::local_to_model);
  return model;
}

/// The hidden joints; empty if the plan hides nothing. If no flag is animated, the frame buffer found the hidden joints
/// once for all frames.
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
  result.local = {};
  result.model = {};
  result.weights = {};
  result.properties = {};
  result.hidden = {};
  show_tables(plan, reuse.tables(), result);
  result.work = FrameWork(reuse.tables().stage_ns).counters();
}

/// in   ops  number of operations of the pose program to run
PoseSpan make_pose(const CompiledPlan& plan, const FrameInput& input, const FrameStep& step, std::size_t ops,
                   FrameWork& work) noexcept {
  const PoseStep pose_step{.inputs = input.program_inputs,
                           .root = input.root,
                           .given_weights = input.weights,
                           .memory = step.memory,
                           .has_base = step.reuse.stands().base_pose,
                           .end = ops};
  if (!input.program.empty()) return evaluate_program(plan, input, pose_step, step.reuse, work);
  return plan.interpolate ? interpolate_poses(plan, input, step, work)
                          : evaluate_layers(plan, input.layers, pose_step, work);
}

/// Runs the stages that follow the pose.
void run_stages_after_pose(const CompiledPlan& plan, const FrameInput& input, const FrameStep& step, PoseSpan local,
                           FrameWork& work, FrameResult& result) noexcept {
  const FrameMemory memory = step.memory;
  const std::span<const float> weights = correct_weights(plan, local, memory, work);
  const bool uses_unmoved = plan.needs.out.local_pose || step.reuse.stands().matrices == StandingMatrices::none;
  if (uses_unmoved && mixes_poses(plan, input)) local = with_unmoved_at_rest(plan, local, memory);
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
  result.local = plan.needs.out.local_pose ? local : PoseSpan{};
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
    const FrameStep step{memory, reuse, reuse.tables(), past_caches};
    FrameWork work(step.tables.stage_ns);
    run_stages_after_pose(plan, input, step, make_pose(plan, input, step, kMostPoseOps, work), work, result);
  }
}

void evaluate_to_cut(const CompiledPlan& plan, const FrameInput& input, FrameMemory memory, const Reuse& reuse,
                     std::size_t ops, CutPose& pose, FrameResult& result) noexcept {
  const FrameStep step{memory, reuse, reuse.tables(), false};
  FrameWork work(step.tables.stage_ns);
  const PoseSpan own = memory.of(plan.layout.pose.pose);
  pose.local = make_pose(plan, input, step, ops, work);
  if (input.program.empty() && pose.local.planes != own.planes) {  // `local` is a pose that later frames use
    copy_pose(pose.local, own);
    pose.local = own;
  }
  pose.model = compose(plan, pose.local, input, step, work);
  result.work = work.counters();
}

void evaluate_from_cut(const CompiledPlan& plan, const FrameInput& input, FrameMemory memory, const Reuse& reuse,
                       std::size_t ops, bool past_caches, FrameResult& result) noexcept {
  const FrameStep step{memory, reuse, reuse.tables(), past_caches};
  FrameWork work(step.tables.stage_ns, result.work);
  if (!input.program.empty())
    evaluate_program(plan, input, {input.program_inputs, input.root, input.weights, memory, false, ops}, reuse, work);
  run_stages_after_pose(plan, input, step, memory.of(plan.layout.pose.pose), work, result);
}

}  // namespace sinew
