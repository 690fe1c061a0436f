// SPDX-License-Identifier: MIT
#include "runtime/c/cut_frame.h"

#include "runtime/c/boundary.h"
#include "runtime/c/frame_handle.h"
#include "runtime/plan/cut_frame.h"

using namespace sinew;

sinew_error sinew_run_to_cut(sinew_frame* frame, const sinew_frame_input* input, std::size_t ops,
                             sinew_cut_pose* pose) {
  if (frame == nullptr || pose == nullptr) return SINEW_NULL_ARGUMENT;
  if (const sinew_error error = c::write_struct(sinew_cut_pose{}, pose); error != SINEW_OK) return error;
  FrameInput own;
  const c::NotRead why = c::read_input(input, *frame->plan, frame->room, own);
  if (why.error != SINEW_OK) return why.error;
  CutPose cut;
  const ErrorCode error = run_to_cut(frame->plan->plan, own, frame->buffer, cut, ops);
  if (error != ErrorCode::ok) return c::error_from(error);
  return c::write_struct({.struct_size = 0,
                          .local = {cut.local.planes, cut.local.joint_count},
                          .model = c::span_from<sinew_affines>(cut.model)},
                         pose);
}

sinew_error sinew_run_from_cut(sinew_frame* frame, const sinew_frame_input* input) {
  if (frame == nullptr) return SINEW_NULL_ARGUMENT;
  FrameInput own;
  const c::NotRead why = c::read_input(input, *frame->plan, frame->room, own);
  if (why.error != SINEW_OK) return why.error;
  return c::error_from(run_from_cut(frame->plan->plan, own, frame->buffer));
}
