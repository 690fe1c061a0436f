// SPDX-License-Identifier: MIT
#include "runtime/plan/cut_frame.h"

#include <utility>

#include "runtime/base/all_finite.h"
#include "runtime/plan/check_input.h"
#include "runtime/plan/evaluate/evaluate_frame.h"
#include "runtime/plan/reuse/reuse.h"

namespace sinew {
namespace {

bool is_finite(const PoseSpan& pose) noexcept {
  for (std::size_t p = 0; p < PoseSpan::plane_count; ++p)
    if (!all_finite(std::span<const float>(pose.plane(static_cast<PoseSpan::Plane>(p)), pose.joint_count)))
      return false;
  return true;
}

}  // namespace

ErrorCode run_to_cut(const Plan& plan, const FrameInput& input, FrameBuffer& frame, CutPose& pose,
                     std::size_t ops) noexcept {
  if (const Refusal refusal = check_run(plan, input, frame, frame.before_); refusal.error != ErrorCode::ok)
    return refusal.error;
  const CompiledPlan& compiled = *plan.compiled();
  if (!compiled.needs.in.cut) return ErrorCode::not_in_needs;
  if (input.asleep || ops == 0) return ErrorCode::unsupported;
  const FrameMemory memory{frame.block_.get()};
  const FrameTables tables(compiled, memory);
  const Reuse nothing_stands(compiled, tables, {memory, frame.last_}, {memory, frame.last_}, frame.result_.frame + 1);
  evaluate_to_cut(compiled, input, memory, nothing_stands, ops, pose, frame.result_);
  frame.last_.is_known = false;  // the caller is about to change the pose in the memory
  frame.cut_pose_ = pose.local;
  frame.cut_ops_ = ops;
  return ErrorCode::ok;
}

ErrorCode run_from_cut(const Plan& plan, const FrameInput& input, FrameBuffer& frame) noexcept {
  if (frame.plan_ == nullptr || frame.plan_.get() != plan.compiled().get() || frame.cut_pose_.planes == nullptr)
    return ErrorCode::no_cut;
  const CompiledPlan& compiled = *plan.compiled();
  if (const Refusal refusal = check_input(compiled, input); refusal.error != ErrorCode::ok) return refusal.error;
  if (!is_finite(frame.cut_pose_)) return ErrorCode::not_finite;
  frame.cut_pose_ = {};
  const FrameBuffer* const followed = std::exchange(frame.before_, nullptr);
  const FrameBuffer& before = followed != nullptr && followed->result_.since_frame != 0 ? *followed : frame;
  const FrameMemory memory{frame.block_.get()};
  const FrameTables tables(compiled, memory);
  const Reuse palettes_stand(compiled, tables, {memory, frame.last_}, {{before.block_.get()}, before.last_},
                             frame.result_.frame + 1);
  frame.result_.frame = frame.result_.since_frame = palettes_stand.number();
  evaluate_from_cut(compiled, input, memory, palettes_stand, frame.cut_ops_, frame.past_caches_, frame.result_);
  return ErrorCode::ok;
}

}  // namespace sinew
