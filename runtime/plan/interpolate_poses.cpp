// SPDX-License-Identifier: MIT
#include "runtime/plan/interpolate_poses.h"

#include <algorithm>
#include <cassert>

#include "runtime/plan/evaluate_pose.h"
#include "runtime/plan/same_layers.h"
#include "runtime/pose/blend_poses.h"
#include "runtime/pose/blend_weights.h"

namespace sinew {
namespace {

/// A pose with its numbers, in some frame's memory.
struct PoseAndNumbers {
  PoseSpan pose;
  std::span<float> weights, properties;

  PoseAndNumbers(const Plan& plan, const PosePlaces& places, FrameMemory memory) noexcept
      : pose(memory.pose(places.pose_at, plan.rig.joint_count())),
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

std::span<ClipLayer> layers_of_end(const Plan& plan, FrameMemory memory, std::size_t end) noexcept {
  return memory.array<ClipLayer>(plan.tables.end_layers_at[end], plan.tables.input_layer_count);
}

/// Takes the pose of these layers from wherever a frame has it already; false where none does.
bool take_end(const Plan& plan, std::span<const ClipLayer> layers, std::size_t end, const FrameStep& step) noexcept {
  const auto has = [&](const FrameTables& tables, FrameMemory memory, std::size_t e) {
    return tables.ends[e].is_there &&
           same_layers(layers, layers_of_end(plan, memory, e).first(tables.ends[e].layer_count));
  };
  if (has(step.tables, step.memory, end)) return true;
  const PoseAndNumbers own(plan, plan.ends[end], step.memory);
  for (std::size_t e = 0; e < 2; ++e) {
    if (has(step.tables, step.memory, e)) return own.take({plan, plan.ends[e], step.memory}), true;
    if (has(step.tables_before, step.memory_before, e)) return own.take({plan, plan.ends[e], step.memory_before}), true;
  }
  return false;
}

/// Makes the pose of these layers the frame's end of that number.
void fill_end(const Plan& plan, std::span<const ClipLayer> layers, std::size_t end, const FrameStep& step,
              FrameWork& work) noexcept {
  if (!take_end(plan, layers, end, step)) {
    PoseAndNumbers made(plan, {plan.pose_at, plan.weights_at, plan.properties_at}, step.memory);
    made.pose = evaluate_pose(plan, {.layers = layers, .weights = {}, .root = {}}, step.memory,
                              step.tables.blend_layers, false, work);
    PoseAndNumbers(plan, plan.ends[end], step.memory).take(made);
  }
  UpdateEnd& kept = step.tables.ends[end];
  kept.is_there = layers.size() <= plan.tables.input_layer_count;
  kept.layer_count = kept.is_there ? layers.size() : 0;
  std::copy_n(layers.begin(), kept.layer_count, layers_of_end(plan, step.memory, end).begin());
  work.spent_on(Stage::interpolate);
}

/// eq   out = (1 - interpolation_factor) first + interpolation_factor second
/// in   out   has the numbers of `first` already
void mix(const PoseAndNumbers& first, const PoseAndNumbers& second, float interpolation_factor,
         const PoseAndNumbers& out) noexcept {
  const BlendLayer shares[2] = {{first.pose, 1.0f - interpolation_factor, {}}, {second.pose, interpolation_factor, {}}};
  const BlendPosesJob job{.layers = shares, .rest = first.pose, .pose = out.pose};
  assert(check(job) == ErrorCode::ok);
  run(job);
  blend_weights(shares, first.weights, out.weights, second.weights);
  blend_weights(shares, first.properties, out.properties, second.properties);
}

}  // namespace

PoseSpan interpolate_poses(const Plan& plan, const FrameInput& input, const FrameStep& step, FrameWork& work) noexcept {
  const PoseAndNumbers own(plan, {plan.pose_at, plan.weights_at, plan.properties_at}, step.memory);
  const PoseAndNumbers ends[2] = {{plan, plan.ends[0], step.memory}, {plan, plan.ends[1], step.memory}};
  fill_end(plan, input.layers, 0, step, work);
  if (input.interpolation_factor != 0.0f) fill_end(plan, input.next_layers, 1, step, work);
  own.take_numbers(ends[0]);
  if (input.interpolation_factor != 0.0f) {
    mix(ends[0], ends[1], input.interpolation_factor, own);
    work.poses_interpolated += 1;
  }
  if (!input.weights.empty()) std::copy(input.weights.begin(), input.weights.end(), own.weights.begin());
  work.spent_on(Stage::interpolate);
  return input.interpolation_factor != 0.0f ? own.pose : ends[0].pose;
}

}  // namespace sinew
