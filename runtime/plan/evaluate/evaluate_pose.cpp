// SPDX-License-Identifier: MIT
#include "runtime/plan/evaluate/evaluate_pose.h"

#include <algorithm>

#include "runtime/plan/pose_operations.h"
#include "runtime/pose_program/pose_machine.h"
#include "runtime/pose_program/read_properties.h"

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

/// Runs pose operations on the memory of a frame. The lowest pose of the stack is the frame's own.
class FrameMachine {
 public:
  FrameMachine(const CompiledPlan& plan, const PoseProgramInputs& inputs, const PoseStep& step,
               FrameWork& work) noexcept
      : assets_(pose_assets(plan, step.memory)),
        own_(step.memory.of(plan.layout.pose)),
        work_(work),
        machine_(
            assets_, inputs,
            PoseSlots(assets_, pose_room(plan), step.memory.of(plan.layout.pose_program).data(),
                      {own_.pose, step.given_weights.empty() ? own_.weights : std::span<float>{}, own_.properties}),
            done_, {&charge_time, &work}) {
    std::copy(step.given_weights.begin(), step.given_weights.end(), own_.weights.begin());
  }

  void run(const PoseOp& op, const PoseMachine::Step& step) noexcept { machine_.run(op, step); }
  void skip(const PoseOp& op) noexcept { machine_.skip(op); }

  /// Counts the work.     out  the topmost pose
  PoseSpan finish() noexcept {
    work_.tracks_sampled += done_.tracks_sampled;
    work_.properties_sampled += done_.properties_sampled;
    work_.poses_mirrored += done_.poses_mirrored;
    work_.poses_blended += done_.poses_blended;
    work_.poses_added += done_.poses_added;
    work_.poses_copied += done_.poses_copied;
    work_.poses_overlaid += done_.poses_overlaid;
    work_.joints_overridden += done_.joints_overridden;
    work_.procedures_run += done_.procedures_run;
    return machine_.top().pose;
  }

 private:
  PoseProgramAssets assets_;
  PoseNumbers own_;
  FrameWork& work_;
  PoseProgramWork done_;
  PoseMachine machine_;
};

/// The pose of a plan whose frames all show the rest pose.
PoseSpan show_rest(const CompiledPlan& plan, const PoseStep& step) noexcept {
  const std::span<const float> weights =
      step.given_weights.empty() ? std::span<const float>(plan.rest_weights) : step.given_weights;
  std::copy(weights.begin(), weights.end(), step.memory.of(plan.layout.pose.weights).begin());
  return step.memory.of(plan.layout.rest_pose);
}

PoseOp sample_of(const ClipLayer& layer) noexcept {
  return {.time_s = layer.time_s,
          .weight = layer.weight,
          .index = static_cast<std::uint16_t>(layer.clip),
          .mask = layer.mask == kNone ? PoseOp::kNoMask : static_cast<std::uint8_t>(layer.mask),
          .kind = layer.mirrored ? PoseOpKind::sample_mirrored : PoseOpKind::sample};
}

bool takes_part(const ClipLayer& layer, bool adds) noexcept {
  return layer.weight != 0.0f && (layer.kind != LayerKind::blend) == adds;
}

/// Adds the difference of a layer from its reference. Properties are not added.
void add(FrameMachine& machine, const ClipLayer& layer) noexcept {
  constexpr PoseMachine::Step kWithoutProperties{.with_properties = false};
  machine.run(sample_of(layer), {.page = layer.page, .with_properties = false});
  if (layer.kind == LayerKind::add_to_rest && !layer.mirrored)
    return machine.run({.kind = PoseOpKind::add_to_rest}, kWithoutProperties);
  if (layer.kind == LayerKind::add_to_rest)
    machine.run({.kind = PoseOpKind::rest_mirrored}, kWithoutProperties);
  else
    machine.run(sample_of({.clip = layer.clip, .mirrored = layer.mirrored}), kWithoutProperties);
  machine.run({.kind = PoseOpKind::add}, kWithoutProperties);
}

}  // namespace

PoseSpan evaluate_layers(const CompiledPlan& plan, std::span<const ClipLayer> layers, const PoseStep& step,
                         FrameWork& work) noexcept {
  if (!plan.poses) return show_rest(plan, step);
  constexpr PoseProgramInputs kNothing{};
  FrameMachine machine(plan, kNothing, step, work);
  std::uint16_t blended = 0;
  for (const ClipLayer& layer : layers) {
    if (!takes_part(layer, false)) continue;
    machine.run(sample_of(layer), {.page = layer.page, .holds_clip = step.has_base});
    ++blended;
  }
  machine.run({.time_s = 1.0, .index = blended, .kind = PoseOpKind::mean}, {});
  for (const ClipLayer& layer : layers)
    if (takes_part(layer, true)) add(machine, layer);
  return machine.finish();
}

PoseSpan evaluate_program(const CompiledPlan& plan, const FrameInput& input, const PoseStep& step,
                          FrameWork& work) noexcept {
  if (!plan.poses) return show_rest(plan, step);
  FrameMachine machine(plan, input.program_inputs, step, work);
  const ReadProperties properties(input.program, plan.properties);
  const std::span<const Clip* const> pages = input.program_inputs.pages;
  const std::size_t end = std::min(step.end, input.program.size());
  for (std::size_t i = 0; i < end; ++i) {
    if (i < step.first)
      machine.skip(input.program[i]);
    else
      machine.run(input.program[i], {.page = pages.empty() ? nullptr : pages[i], .with_properties = properties.of(i)});
  }
  return machine.finish();
}

}  // namespace sinew
