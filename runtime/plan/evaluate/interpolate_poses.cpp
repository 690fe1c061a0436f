// SPDX-License-Identifier: MIT
#include "runtime/plan/evaluate/interpolate_poses.h"

#include <algorithm>
#include <cassert>

#include "runtime/plan/evaluate/evaluate_pose.h"
#include "runtime/pose/blend_poses.h"

namespace sinew {
namespace {

/// Makes sure that the frame's memory holds the pose of an update. Evaluates it if no earlier frame holds it.
/// in   update  0 for FrameInput::layers, 1 for FrameInput::next_layers
void provide_update(const CompiledPlan& plan, const FrameInput& input, std::size_t update, const FrameStep& step,
                    FrameWork& work) noexcept {
  const std::span<const ClipLayer> layers = update == 0 ? input.layers : input.next_layers;
  const bool may_keep = input.program_inputs.masks.empty();  // a mask may change while the layers stay the same
  if (!may_keep || !step.reuse.find_update(update, layers)) {
    const PoseNumbers place = step.memory.of(plan.layout.updates[update]);
    copy_pose(evaluate_layers(plan, layers, {.inputs = input.program_inputs, .root = input.root, .memory = step.memory},
                              work),
              place.pose);
    copy_numbers(step.memory.of(plan.layout.pose), place);
  }
  may_keep ? step.reuse.keep_update(update, layers) : step.reuse.forget_update(update);
  work.spent_on(Stage::interpolate);
}

/// eq   out = (1 - interpolation_factor) first + interpolation_factor second
/// in   out   already holds the numbers of `first`
void mix(const PoseNumbers& first, const PoseNumbers& second, float interpolation_factor,
         const PoseNumbers& out) noexcept {
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
  const PoseNumbers own = step.memory.of(plan.layout.pose), first = step.memory.of(plan.layout.updates[0]),
                    second = step.memory.of(plan.layout.updates[1]);
  provide_update(plan, input, 0, step, work);
  if (input.interpolation_factor != 0.0f) provide_update(plan, input, 1, step, work);
  copy_numbers(first, own);
  if (input.interpolation_factor != 0.0f) {
    mix(first, second, input.interpolation_factor, own);
    work.poses_interpolated += 1;
  }
  if (!input.weights.empty()) std::copy(input.weights.begin(), input.weights.end(), own.weights.begin());
  work.spent_on(Stage::interpolate);
  return input.interpolation_factor != 0.0f ? own.pose : first.pose;
}

}  // namespace sinew
