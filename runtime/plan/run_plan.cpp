// SPDX-License-Identifier: MIT
#include "runtime/plan/run_plan.h"

#include <utility>

#include "runtime/plan/check_input.h"
#include "runtime/plan/evaluate/evaluate_frame.h"
#include "runtime/plan/reuse/reuse.h"

namespace sinew {

Refusal check_buffers(const Plan& plan, const FrameBuffer& frame, const FrameBuffer* followed) noexcept {
  const CompiledPlan* const compiled = plan.compiled().get();
  if (compiled == nullptr) return {ErrorCode::no_plan, "plan"};
  if (frame.plan_ == nullptr) return {ErrorCode::moved_from, "frame"};
  if (frame.plan_.get() != compiled) return {ErrorCode::wrong_plan, "frame"};
  if (followed != nullptr && followed->plan_ == nullptr) return {ErrorCode::moved_from, "the followed frame"};
  if (followed != nullptr && followed->plan_.get() != compiled) return {ErrorCode::wrong_plan, "the followed frame"};
  return {};
}

Refusal check_run(const Plan& plan, const FrameInput& input, const FrameBuffer& frame,
                  const FrameBuffer* followed) noexcept {
  const Refusal refusal = check_buffers(plan, frame, followed);
  return refusal.error != ErrorCode::ok ? refusal : check_input(*plan.compiled(), input);
}

ErrorCode run_plan(const Plan& plan, const FrameInput& input, FrameBuffer& frame) noexcept {
  // 1. Refuse bad input. An input that was accepted in the last run need not be checked again.
  const FrameBuffer* const followed = std::exchange(frame.before_, nullptr);
  if (const Refusal refusal = check_buffers(plan, frame, followed); refusal.error != ErrorCode::ok)
    return refusal.error;
  const CompiledPlan& compiled = *plan.compiled();
  const FrameMemory memory{frame.block_.get()};
  const FrameTables tables(compiled, memory);
  const bool had_it = had_same_input({frame.last_, tables}, input);
  if (!had_it || input.asleep)  // for a sleeping character nothing else was compared
    if (const Refusal refusal = check_input(compiled, input); refusal.error != ErrorCode::ok) return refusal.error;

  // 2. Find the parts that stand: they are still valid (reuse/reuse.h).
  frame.cut_pose_ = {};
  const FrameBuffer& before = followed != nullptr && followed->result_.since_frame != 0 ? *followed : frame;
  const Reuse reuse(compiled, input, tables, {memory, frame.last_}, {{before.block_.get()}, before.last_}, had_it,
                    frame.result_.frame + 1);

  // 3. Evaluate all other parts.
  frame.result_.since_frame = reuse.stands().all_since_before ? before.result_.since_frame : reuse.number();
  frame.result_.frame = reuse.number();
  evaluate_frame(compiled, input, memory, reuse, frame.past_caches_, frame.result_);
  if (!reuse.stands().all) remember(input, reuse.tables(), frame.last_);
  return ErrorCode::ok;
}

std::string why_refused(const Plan& plan, const FrameInput& input, const FrameBuffer& frame) {
  const Refusal refusal = check_run(plan, input, frame, frame.before_);
  return refusal.error == ErrorCode::ok ? std::string() : text_of(refusal);
}

bool holds_result_of(const FrameBuffer& frame, const FrameInput& input) noexcept {
  if (frame.plan_ == nullptr) return false;
  return had_same_input({frame.last_, FrameTables(*frame.plan_, FrameMemory{frame.block_.get()})}, input);
}

}  // namespace sinew
