// SPDX-License-Identifier: MIT
#include "runtime/plan/evaluate/evaluate_pose.h"

#include <algorithm>

#include "runtime/plan/pose_operations.h"
#include "runtime/pose_program/pose_machine.h"
#include "runtime/pose_program/read_properties.h"
#include "runtime/pose_program/standing_operands.h"

namespace sinew {
namespace {

Stage stage_of(PosePhase phase) noexcept {
  switch (phase) {
    case PosePhase::sample: return Stage::sample;
    case PosePhase::mirror: return Stage::mirror;
    case PosePhase::blend: return Stage::blend;
    case PosePhase::add: return Stage::add;
    default: return Stage::pose_program;
  }
}

void charge_time(void* work, PosePhase phase) noexcept { static_cast<FrameWork*>(work)->spent_on(stage_of(phase)); }

/// The lowest pose of the stack: the frame's own output.
PoseSlot own_slot(const CompiledPlan& plan, const PoseStep& step) noexcept {
  const PoseNumbers own = step.memory.of(plan.layout.pose);
  return {own.pose, step.given_weights.empty() ? own.weights : std::span<float>{}, own.properties};
}

/// A machine for pose operations on the memory of a frame.
PoseMachine machine_for(const CompiledPlan& plan, const PoseStep& step, FrameWork& work) noexcept {
  std::copy(step.given_weights.begin(), step.given_weights.end(), step.memory.of(plan.layout.pose.weights).begin());
  return {plan.pose_assets,
          step.memory.of(plan.layout.rest_pose),
          step.inputs,
          step.root,
          PoseSlots(plan.layout.pose_slots, step.memory.of(plan.layout.pose_program).data(), own_slot(plan, step)),
          work,
          {work.measures() ? &charge_time : nullptr, &work}};
}

/// Writes the pose of a plan without animation: the rest pose.
PoseSpan show_rest(const CompiledPlan& plan, const PoseStep& step) noexcept {
  const std::span<const float> weights =
      step.given_weights.empty() ? std::span<const float>(plan.rest_weights) : step.given_weights;
  std::copy(weights.begin(), weights.end(), step.memory.of(plan.layout.pose.weights).begin());
  return step.memory.of(plan.layout.rest_pose);
}

/// Sample operation for a layer. The clip index does not fit into it and is passed in PoseMachine::Step.
PoseOp sample_of(const ClipLayer& layer) noexcept {
  return {.time_s = layer.time_s,
          .weight = layer.weight,
          .mask = layer.mask == kNone ? PoseOp::kNoMask : static_cast<std::uint8_t>(layer.mask),
          .kind = layer.mirrored ? PoseOpKind::sample_mirrored : PoseOpKind::sample};
}

bool takes_part(const ClipLayer& layer, bool adds) noexcept {
  return layer.weight != 0.0f && (layer.kind != LayerKind::blend) == adds;
}

/// Adds the difference of a layer from its reference. Properties are not added.
void add(PoseMachine& machine, const ClipLayer& layer) noexcept {
  constexpr PoseMachine::Step kWithoutProperties{.with_properties = false};
  machine.run(sample_of(layer), {.clip = layer.clip, .page = layer.page, .with_properties = false});
  if (layer.kind == LayerKind::add_to_rest && !layer.mirrored)
    return machine.run({.kind = PoseOpKind::add_to_rest}, kWithoutProperties);
  if (layer.kind == LayerKind::add_to_rest)
    machine.run({.kind = PoseOpKind::rest_mirrored}, kWithoutProperties);
  else
    machine.run(sample_of({.mirrored = layer.mirrored}), {.clip = layer.clip, .with_properties = false});
  machine.run({.kind = PoseOpKind::add}, kWithoutProperties);
}

/// Runs the operations of a program, except those whose results are kept from earlier frames.
void run_keeping(PoseMachine& machine, const FrameInput& input, const PoseStep& step, const ReadProperties& properties,
                 const Reuse& reuse) noexcept {
  const PoseProgramSpan program = input.program;
  const StandingOperands operands(program, properties, reuse.last_program(input), reuse.tables().kept);
  const std::span<const Clip* const> pages = input.program_inputs.pages;
  const std::size_t end = std::min(step.end, program.size());
  for (std::size_t i = 0; i < end; ++i) {
    if (i < step.first || operands.skips(i)) {
      machine.skip(program[i]);
      continue;
    }
    PoseMachine::Step of_op{.page = pages.empty() ? nullptr : pages[i], .with_properties = properties.of(i)};
    if (kept_operands_of(program[i]) > 0) {
      of_op.kept = operands.place(i);
      of_op.kept_stands = operands.stands(i);
    }
    machine.run(program[i], of_op);
  }
}

}  // namespace

PoseSpan evaluate_layers(const CompiledPlan& plan, std::span<const ClipLayer> layers, const PoseStep& step,
                         FrameWork& work) noexcept {
  if (!plan.poses) return show_rest(plan, step);
  PoseMachine machine = machine_for(plan, step, work);
  std::uint16_t blended = 0;
  bool plays_alone = false;  // the mean of a single pose of full weight has the bits of that pose
  for (const ClipLayer& layer : layers) {
    if (!takes_part(layer, false)) continue;
    machine.run(sample_of(layer), {.clip = layer.clip, .page = layer.page, .holds_clip = step.has_base});
    plays_alone = ++blended == 1 && layer.weight >= 1.0f && layer.mask == kNone;
  }
  if (blended != 1 || !plays_alone) machine.run({.time_s = 1.0, .index = blended, .kind = PoseOpKind::mean}, {});
  for (const ClipLayer& layer : layers)
    if (takes_part(layer, true)) add(machine, layer);
  return machine.top().pose;
}

PoseSpan evaluate_program(const CompiledPlan& plan, const FrameInput& input, const PoseStep& step, const Reuse& reuse,
                          FrameWork& work) noexcept {
  if (!plan.poses) return show_rest(plan, step);
  PoseMachine machine = machine_for(plan, step, work);
  const ReadProperties properties(input.program, plan.properties);
  if (plan.needs.in.program.kept > 0) {
    run_keeping(machine, input, step, properties, reuse);
    return machine.top().pose;
  }
  const std::span<const Clip* const> pages = input.program_inputs.pages;
  const std::size_t end = std::min(step.end, input.program.size());
  for (std::size_t i = 0; i < end; ++i) {
    if (i < step.first)
      machine.skip(input.program[i]);
    else
      machine.run(input.program[i], {.page = pages.empty() ? nullptr : pages[i], .with_properties = properties.of(i)});
  }
  return machine.top().pose;
}

}  // namespace sinew
