// SPDX-License-Identifier: MIT
#include "runtime/c/frame.h"

#include <memory>
#include <new>
#include <span>
#include <string>
#include <utility>

#include "runtime/c/cut_frame.h"
#include "runtime/c/frame_input.h"
#include "runtime/c/glue/call.h"
#include "runtime/c/glue/pose_span.h"
#include "runtime/c/glue/struct_versions.h"
#include "runtime/c/handles.h"
#include "runtime/c/input_room.h"
#include "runtime/plan/cut_frame.h"
#include "runtime/plan/frame_buffer.h"
#include "runtime/plan/run_plan.h"

using namespace sinew;

/// This struct lies at the beginning of its own memory. Room for one input and the frame buffer's block follow it.
struct sinew_frame {
  const sinew_plan* plan;
  sinew_allocator allocator;
  c::InputRoom room;
  FrameBuffer buffer;
};

namespace {

static_assert(SINEW_FRAME_ALIGNMENT == FrameBuffer::kAlignment && alignof(sinew_frame) <= SINEW_FRAME_ALIGNMENT);

void* allocate_new(void*, std::size_t byte_count, std::size_t alignment) {
  return ::operator new(byte_count, std::align_val_t(alignment), std::nothrow);
}
void release_new(void*, void* block, std::size_t, std::size_t alignment) {
  ::operator delete(block, std::align_val_t(alignment));
}
void keep_block(void*, void*, std::size_t, std::size_t) {}

c::Block block_of_frame(std::byte* start) noexcept { return {start, c::aligned(sizeof(sinew_frame))}; }

sinew_frame* make_frame(const sinew_plan& plan, std::byte* start, const sinew_allocator& allocator) {
  c::Block block = block_of_frame(start);
  const c::InputRoom room(plan, block);
  const std::span<std::byte> own(start + block.used, plan.plan.frame_bytes());
  return new (start) sinew_frame{&plan, allocator, room, FrameBuffer(plan.plan, own)};
}

/// Runs `run` with the input of a C caller.
sinew_error run_with(const sinew_frame* frame, const sinew_frame_input* input, auto&& run) noexcept {
  return c::call(c::given(frame), [&] {
    FrameInput own;
    const c::NotRead why = c::read_input(input, *frame->plan, frame->room, own);
    return why.error == SINEW_OK ? c::error_from(run(own)) : why.error;
  });
}

}  // namespace

std::size_t sinew_plan_frame_bytes(const sinew_plan* plan) {
  if (plan == nullptr) return 0;
  c::Block counted = block_of_frame(nullptr);
  c::InputRoom(*plan, counted);
  return counted.used + plan->plan.frame_bytes();
}

sinew_error sinew_frame_create(const sinew_plan* plan, const sinew_allocator* allocator, sinew_frame** out) {
  const sinew_allocator own = allocator != nullptr ? *allocator : sinew_allocator{nullptr, allocate_new, release_new};
  return c::call(c::given(plan, out, own.allocate, own.release), [&] {
    void* block = own.allocate(own.context, sinew_plan_frame_bytes(plan), SINEW_FRAME_ALIGNMENT);
    if (block == nullptr) return SINEW_OUT_OF_MEMORY;
    *out = make_frame(*plan, static_cast<std::byte*>(block), own);
    return SINEW_OK;
  });
}

sinew_error sinew_frame_create_in(const sinew_plan* plan, void* block, std::size_t byte_count, sinew_frame** out) {
  return c::call(c::given(plan, block, out), [&] {
    if (byte_count < sinew_plan_frame_bytes(plan)) return SINEW_SIZE_MISMATCH;
    if (reinterpret_cast<std::uintptr_t>(block) % SINEW_FRAME_ALIGNMENT != 0) return SINEW_SIZE_MISMATCH;
    *out = make_frame(*plan, static_cast<std::byte*>(block), {nullptr, nullptr, keep_block});
    return SINEW_OK;
  });
}

void sinew_frame_destroy(sinew_frame* frame) {
  if (frame == nullptr) return;
  const sinew_allocator allocator = frame->allocator;
  const std::size_t byte_count = sinew_plan_frame_bytes(frame->plan);
  frame->~sinew_frame();
  allocator.release(allocator.context, frame, byte_count, SINEW_FRAME_ALIGNMENT);
}

sinew_error sinew_run(sinew_frame* frame, const sinew_frame_input* input) {
  return run_with(frame, input, [&](const FrameInput& own) { return run_plan(frame->plan->plan, own, frame->buffer); });
}

sinew_error sinew_run_to_cut(sinew_frame* frame, const sinew_frame_input* input, std::size_t ops,
                             sinew_cut_pose* pose) {
  if (const sinew_error error = c::write_struct(sinew_cut_pose{}, pose)) return error;
  return run_with(frame, input, [&](const FrameInput& own) {
    CutPose cut;
    const ErrorCode error = run_to_cut(frame->plan->plan, own, frame->buffer, cut, ops);
    if (error != ErrorCode::ok) return c::error_from(error);
    return c::write_struct({.struct_size = 0, .local = c::to_c(cut.local), .model = c::to_c(cut.model)}, pose);
  });
}

sinew_error sinew_run_from_cut(sinew_frame* frame, const sinew_frame_input* input) {
  return run_with(frame, input,
                  [&](const FrameInput& own) { return run_from_cut(frame->plan->plan, own, frame->buffer); });
}

sinew_error sinew_why_refused(const sinew_frame* frame, const sinew_frame_input* input, sinew_messages** why) {
  return c::call(c::given(frame, why), [&] {
    const c::OwnRoom<c::InputRoom> room(*frame->plan);
    FrameInput own;
    const c::NotRead not_read = c::read_input(input, *frame->plan, room.room(), own);
    std::string line =
        not_read.error != SINEW_OK ? text_of(not_read.where) : why_refused(frame->plan->plan, own, frame->buffer);
    *why = line.empty() ? nullptr : new sinew_messages{{std::move(line)}};
  });
}

void sinew_frame_prefetch(const sinew_frame* frame) {
  if (frame != nullptr) frame->buffer.prefetch();
}

void sinew_frame_write_past_caches(sinew_frame* frame, int past_caches) {
  if (frame != nullptr) frame->buffer.write_past_caches(past_caches != 0);
}

const sinew_result* sinew_frame_result(const sinew_frame* frame) {
  if (frame == nullptr) return nullptr;
  return reinterpret_cast<const sinew_result*>(&frame->buffer.result());
}
