// SPDX-License-Identifier: MIT
// Operations of the pose machine that keep numbers of their operands for later frames.
#include <algorithm>
#include <cassert>

#include "runtime/pose_program/pose_machine.h"
#include "runtime/transition/dead_blend.h"
#include "runtime/transition/inertialize.h"

namespace sinew {
namespace {

TransitionPose transition_pose(const PoseSlot& slot) noexcept { return {slot.pose, slot.weights, slot.properties}; }

void copy(std::span<const float> from, std::span<float> to) noexcept {
  std::copy_n(from.begin(), std::min(from.size(), to.size()), to.begin());
}

}  // namespace

void PoseMachine::inertialize(const PoseOp& op) noexcept {
  depth_ -= 4;
  if (op.time_s >= 1.0) return;
  const TransitionNumbers numbers = slots_.kept(step_.kept);
  const auto operand = [&](std::size_t above) { return transition_pose(slot(depth_ + above)); };
  if (!step_.kept_stands) {
    make_offsets({operand(0), operand(1), operand(2), operand(3), op.index}, numbers);
    ++work_.transitions_started;
  }
  const InertializeJob job{numbers, static_cast<float>(op.time_s), transition_pose(slot(depth_ - 1))};
  assert(check(job) == ErrorCode::ok);
  run_unchecked(job);
  ++work_.poses_in_transition;
  ended(PosePhase::transition);
}

void PoseMachine::dead_blend(const PoseOp& op) noexcept {
  depth_ -= 2;
  if (op.time_s >= 1.0) return;
  const TransitionNumbers numbers = slots_.kept(step_.kept);
  if (!step_.kept_stands) {
    make_extrapolation({transition_pose(slot(depth_)), transition_pose(slot(depth_ + 1)), op.index}, numbers);
    ++work_.transitions_started;
  }
  const DeadBlendJob job{numbers, static_cast<float>(op.time_s), transition_pose(slot(depth_ - 1))};
  assert(check(job) == ErrorCode::ok);
  run_unchecked(job);
  ++work_.poses_in_transition;
  ended(PosePhase::transition);
}

void PoseMachine::cache_top() noexcept {
  const TransitionNumbers numbers = slots_.kept(step_.kept);
  const PoseSlot pose = slot(depth_ - 1);
  const std::size_t floats = PoseSpan::floats_for(numbers.joint_count);
  if (step_.kept_stands) {
    std::copy_n(numbers.planes, floats, pose.pose.planes);
    copy(numbers.weights, pose.weights);
    copy(numbers.properties, pose.properties);
  } else {
    std::copy_n(pose.pose.planes, floats, numbers.planes);
    copy(pose.weights, numbers.weights);
    copy(pose.properties, numbers.properties);
  }
}

}  // namespace sinew
