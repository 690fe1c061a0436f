// SPDX-License-Identifier: MIT
#include "runtime/plan/run_plan.h"

#include <utility>

#include "runtime/plan/check_input.h"
#include "runtime/plan/evaluate/evaluate_frame.h"
#include "runtime/plan/reuse/reuse.h"

namespace sinew {

ErrorCode run_plan(const Plan& plan, const FrameInput& input, FrameBuffer& frame) noexcept {
  // 1. Refuse bad input.
  const CompiledPlan* const compiled = plan.compiled().get();
  const FrameBuffer* const other = std::exchange(frame.before_, nullptr);
  if (compiled == nullptr || frame.plan_.get() != compiled) return ErrorCode::size_mismatch;
  if (other != nullptr && other->plan_.get() != compiled) return ErrorCode::size_mismatch;
  if (const ErrorCode error = check(*compiled, input); error != ErrorCode::ok) return error;

  // 2. Find what stands.
  const FrameBuffer& before = other != nullptr && other->result_.since_frame != 0 ? *other : frame;
  const FrameMemory memory{frame.block_.get()};
  const Reuse reuse(*compiled, input, {memory, frame.last_}, {{before.block_.get()}, before.last_},
                    frame.result_.frame + 1);

  // 3. Evaluate the rest.
  frame.result_.since_frame = reuse.stands().all_since_before ? before.result_.since_frame : reuse.number();
  frame.result_.frame = reuse.number();
  evaluate_frame(*compiled, input, memory, reuse, frame.past_caches_, frame.result_);
  if (!reuse.stands().all) remember(input, reuse.tables(), frame.last_);
  return ErrorCode::ok;
}

bool holds_result_of(const FrameBuffer& frame, const FrameInput& input) noexcept {
  if (frame.plan_ == nullptr) return false;
  return had_same_input({frame.last_, FrameTables(*frame.plan_, FrameMemory{frame.block_.get()})}, input);
}

}  // namespace sinew
