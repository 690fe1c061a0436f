// SPDX-License-Identifier: MIT
#include "runtime/c/frame.h"

#include <memory>
#include <new>
#include <span>
#include <string>
#include <utility>

#include "runtime/c/boundary.h"
#include "runtime/c/frame_handle.h"
#include "runtime/c/handles.h"
#include "runtime/plan/compiled_plan.h"
#include "runtime/plan/run_plan.h"

using namespace sinew;

namespace {

static_assert(SINEW_FRAME_ALIGNMENT == FrameBuffer::kAlignment && alignof(sinew_frame) <= SINEW_FRAME_ALIGNMENT);

constexpr std::size_t aligned(std::size_t bytes) noexcept {
  return (bytes + SINEW_FRAME_ALIGNMENT - 1) / SINEW_FRAME_ALIGNMENT * SINEW_FRAME_ALIGNMENT;
}

void* allocate_new(void*, std::size_t byte_count, std::size_t alignment) {
  return ::operator new(byte_count, std::align_val_t(alignment), std::nothrow);
}
void release_new(void*, void* block, std::size_t, std::size_t alignment) {
  ::operator delete(block, std::align_val_t(alignment));
}
void keep_block(void*, void*, std::size_t, std::size_t) {}

/// The memory of a frame, out of which arrays are taken one after another.
struct OwnBlock {
  std::byte* start = nullptr;  // null: bytes are counted alone
  std::size_t used = aligned(sizeof(sinew_frame));

  template <class T>
  std::span<T> take(std::size_t count) {
    std::span<T> taken;
    if (start != nullptr) {
      taken = {reinterpret_cast<T*>(start + used), count};
      std::uninitialized_value_construct(taken.begin(), taken.end());
    }
    used += aligned(count * sizeof(T));
    return taken;
  }
};

c::InputRoom take_room(const sinew_plan& plan, OwnBlock& block) {
  const PoseProgramRoom& program = plan.plan.needs().in.program;
  c::InputRoom room;
  room.layers = block.take<ClipLayer>(plan.input_room());
  room.geometry = block.take<GeometryInput>(plan.geometry_room());
  room.program.externals = block.take<ExternalPose>(program.externals);
  room.program.overrides = block.take<JointOverrides>(program.overrides);
  room.program.procedures = block.take<PoseProcedure>(program.procedures);
  room.program.masks = block.take<JointMask>(program.masks);
  return room;
}

sinew_frame* make_frame(const sinew_plan& plan, std::byte* start, const sinew_allocator& allocator) {
  OwnBlock block{start};
  const c::InputRoom room = take_room(plan, block);
  const std::span<std::byte> own(start + block.used, plan.plan.frame_bytes());
  return new (start) sinew_frame{&plan, allocator, room, FrameBuffer(plan.plan, own)};
}

}  // namespace

std::size_t sinew_plan_frame_bytes(const sinew_plan* plan) {
  if (plan == nullptr) return 0;
  OwnBlock counted;
  take_room(*plan, counted);
  return counted.used + plan->plan.frame_bytes();
}

sinew_error sinew_frame_create(const sinew_plan* plan, const sinew_allocator* allocator, sinew_frame** out) {
  if (plan == nullptr || out == nullptr) return SINEW_NULL_ARGUMENT;
  const sinew_allocator own = allocator != nullptr ? *allocator : sinew_allocator{nullptr, allocate_new, release_new};
  if (own.allocate == nullptr || own.release == nullptr) return SINEW_NULL_ARGUMENT;
  void* block = own.allocate(own.context, sinew_plan_frame_bytes(plan), SINEW_FRAME_ALIGNMENT);
  if (block == nullptr) return SINEW_OUT_OF_MEMORY;
  *out = make_frame(*plan, static_cast<std::byte*>(block), own);
  return SINEW_OK;
}

sinew_error sinew_frame_create_in(const sinew_plan* plan, void* block, std::size_t byte_count, sinew_frame** out) {
  if (plan == nullptr || block == nullptr || out == nullptr) return SINEW_NULL_ARGUMENT;
  if (byte_count < sinew_plan_frame_bytes(plan)) return SINEW_SIZE_MISMATCH;
  if (reinterpret_cast<std::uintptr_t>(block) % SINEW_FRAME_ALIGNMENT != 0) return SINEW_SIZE_MISMATCH;
  *out = make_frame(*plan, static_cast<std::byte*>(block), {nullptr, nullptr, keep_block});
  return SINEW_OK;
}

void sinew_frame_destroy(sinew_frame* frame) {
  if (frame == nullptr) return;
  const sinew_allocator allocator = frame->allocator;
  const std::size_t byte_count = sinew_plan_frame_bytes(frame->plan);
  frame->~sinew_frame();
  allocator.release(allocator.context, frame, byte_count, SINEW_FRAME_ALIGNMENT);
}

sinew_error sinew_run(sinew_frame* frame, const sinew_frame_input* input) {
  if (frame == nullptr) return SINEW_NULL_ARGUMENT;
  FrameInput own;
  const c::NotRead why = c::read_input(input, *frame->plan, frame->room, own);
  if (why.error != SINEW_OK) return why.error;
  return c::error_from(run_plan(frame->plan->plan, own, frame->buffer));
}

sinew_error sinew_why_refused(const sinew_frame* frame, const sinew_frame_input* input, sinew_messages** why) {
  if (frame == nullptr || why == nullptr) return SINEW_NULL_ARGUMENT;
  return c::guarded([&] {
    c::OwnInputRoom room(*frame->plan);
    FrameInput own;
    const c::NotRead not_read = c::read_input(input, *frame->plan, room.room(), own);
    std::string line =
        not_read.error != SINEW_OK ? text_of(not_read.where) : why_refused(frame->plan->plan, own, frame->buffer);
    *why = line.empty() ? nullptr : new sinew_messages{{std::move(line)}};
    return SINEW_OK;
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
