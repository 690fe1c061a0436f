// SPDX-License-Identifier: MIT
#include "runtime/plan/interpolate_poses.h"

#include <algorithm>
#include <cassert>

#include "runtime/plan/evaluate_pose.h"
#include "runtime/pose/blend_poses.h"
#include "runtime/pose/blend_weights.h"

namespace sinew {
namespace {

/// A pose with its numbers, in some frame's memory.
struct PoseAndNumbers {
  PoseSpan pose;
  std::span<float> weights, properties;

  PoseAndNumbers(const CompiledPlan& plan, const PoseLayout& places, FrameMemory memory) noexcept
      : pose(memory.pose(places.pose_at, plan.assets.joint_count())),
        weights(memory.array<float>(places.weights_at, plan.rest_weights.size())),
        properties(
            memory.array<float>(places.properties_at, plan.properties ? plan.scene->properties.rest.size() : 0)) {}

  void take(const PoseAndNumbers& from) const noexcept {
    std::copy_n(from.pose.planes, PoseSpan::floats_for(pose.joint_count), pose.planes);
    take_numbers(from);
  }
  void take_numbers(const PoseAndNumbers& from) const noexcept {
    std::copy(from.weights.begin(), from.weights.end(), weights.begin());
    std::copy(from.properties.begin(), from.properties.end(), properties.begin());
  }
};

std::span<ClipLayer> layers_of_update(const CompiledPlan& plan, FrameMemory memory, std::size_t update) noexcept {
  return memory.array<ClipLayer>(plan.layout.tables.update_layers_at[update], plan.layout.tables.input_layer_count);
}

/// Copies the pose of these layers from wherever this frame's memory or that of the frame before has it; false where
/// neither does.
bool reuse_update(const CompiledPlan& plan, std::span<const ClipLayer> layers, std::size_t update,
                  const FrameStep& step) noexcept {
  const auto has = [&](const FrameTables& tables, FrameMemory memory, std::size_t u) {
    return tables.updates[u].is_there &&
           same_layers(layers, layers_of_update(plan, memory, u).first(tables.updates[u].layer_count));
  };
  if (has(step.tables, step.memory, update)) return true;
  const PoseAndNumbers own(plan, plan.layout.updates[update], step.memory);
  for (std::size_t u = 0; u < 2; ++u) {
    if (has(step.tables, step.memory, u)) {
      own.take({plan, plan.layout.updates[u], step.memory});
      return true;
    }
    if (has(step.tables_before, step.memory_before, u)) {
      own.take({plan, plan.layout.updates[u], step.memory_before});
      return true;
    }
  }
  return false;
}

/// Provides the pose of these layers in the frame's memory, evaluated where no memory has it.
/// in   update  0 for FrameInput::layers, 1 for FrameInput::next_layers
void provide_update(const CompiledPlan& plan, std::span<const ClipLayer> layers, std::size_t update,
                    const FrameStep& step, FrameWork& work) noexcept {
  if (!reuse_update(plan, layers, update, step)) {
    PoseAndNumbers made(plan, {plan.layout.pose_at, plan.layout.weights_at, plan.layout.properties_at}, step.memory);
    made.pose = evaluate_pose(plan, layers, {}, step.memory, step.tables.blend_layers, false, work);
    PoseAndNumbers(plan, plan.layout.updates[update], step.memory).take(made);
  }
  KeptUpdate& kept = step.tables.updates[update];
  kept.is_there = layers.size() <= plan.layout.tables.input_layer_count;
  kept.layer_count = kept.is_there ? layers.size() : 0;
  std::copy_n(layers.begin(), kept.layer_count, layers_of_update(plan, step.memory, update).begin());
  work.spent_on(Stage::interpolate);
}

/// eq   out = (1 - interpolation_factor) first + interpolation_factor second
/// in   out   has the numbers of `first` already
void mix(const PoseAndNumbers& first, const PoseAndNumbers& second, float interpolation_factor,
         const PoseAndNumbers& out) noexcept {
  const BlendLayer shares[2] = {{first.pose, 1.0f - interpolation_factor, {}}, {second.pose, interpolation_factor, {}}};
  const BlendPosesJob job{.layers = shares, .rest = first.pose, .pose = out.pose};
  assert(check(job) == ErrorCode::ok);
  run_unchecked(job);
  blend_weights(shares, first.weights, out.weights, second.weights);
  blend_weights(shares, first.properties, out.properties, second.properties);
}

}  // namespace

PoseSpan interpolate_poses(const CompiledPlan& plan, const FrameInput& input, const FrameStep& step,
                           FrameWork& work) noexcept {
  const PoseAndNumbers own(plan, {plan.layout.pose_at, plan.layout.weights_at, plan.layout.properties_at}, step.memory);
  const PoseAndNumbers first(plan, plan.layout.updates[0], step.memory);
  const PoseAndNumbers second(plan, plan.layout.updates[1], step.memory);
  provide_update(plan, input.layers, 0, step, work);
  if (input.interpolation_factor != 0.0f) provide_update(plan, input.next_layers, 1, step, work);
  own.take_numbers(first);
  if (input.interpolation_factor != 0.0f) {
    mix(first, second, input.interpolation_factor, own);
    work.poses_interpolated += 1;
  }
  if (!input.weights.empty()) std::copy(input.weights.begin(), input.weights.end(), own.weights.begin());
  work.spent_on(Stage::interpolate);
  return input.interpolation_factor != 0.0f ? own.pose : first.pose;
}

}  // namespace sinew
