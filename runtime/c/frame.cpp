// SPDX-License-Identifier: MIT
#include "runtime/c/frame.h"

#include <memory>
#include <new>

#include "runtime/c/boundary.h"
#include "runtime/c/frame_input.h"
#include "runtime/c/handles.h"
#include "runtime/plan/compiled_plan.h"
#include "runtime/plan/run_plan.h"

using namespace sinew;

/// Lies at the beginning of its own memory; the room for one input and the frame buffer's block follow.
struct sinew_frame {
  const sinew_plan* plan;
  sinew_allocator allocator;
  c::InputRoom room;
  FrameBuffer buffer;
};

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

std::size_t layer_bytes(const sinew_plan& plan) noexcept { return aligned(plan.input_room() * sizeof(ClipLayer)); }
std::size_t geometry_bytes(const sinew_plan& plan) noexcept {
  return aligned(plan.geometry_room() * sizeof(GeometryInput));
}

sinew_frame* make_frame(const sinew_plan& plan, std::byte* block, const sinew_allocator& allocator) {
  std::byte* const room = block + aligned(sizeof(sinew_frame));
  auto* layers = reinterpret_cast<ClipLayer*>(room);
  auto* geometry = reinterpret_cast<GeometryInput*>(room + layer_bytes(plan));
  std::uninitialized_value_construct_n(layers, plan.input_room());
  std::uninitialized_value_construct_n(geometry, plan.geometry_room());
  std::byte* own = room + layer_bytes(plan) + geometry_bytes(plan);
  return new (block) sinew_frame{&plan,
                                 allocator,
                                 {{layers, plan.input_room()}, {geometry, plan.geometry_room()}},
                                 FrameBuffer(plan.plan, {own, plan.plan.frame_bytes()})};
}

const FrameResult& result_behind(const sinew_result* result) noexcept {
  return *reinterpret_cast<const FrameResult*>(result);
}

}  // namespace

std::size_t sinew_plan_frame_bytes(const sinew_plan* plan) {
  if (plan == nullptr) return 0;
  return aligned(sizeof(sinew_frame)) + layer_bytes(*plan) + geometry_bytes(*plan) + plan->plan.frame_bytes();
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
  if (const sinew_error error = c::read_input(input, *frame->plan, frame->room, own); error != SINEW_OK) return error;
  return c::error_from(run_plan(frame->plan->plan, own, frame->buffer));
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

sinew_error sinew_get_result(const sinew_result* result, sinew_result_info* out) {
  if (result == nullptr) return SINEW_NULL_ARGUMENT;
  const FrameResult& frame = result_behind(result);
  return c::write_struct({.struct_size = 0,
                          .frame = frame.frame,
                          .since_frame = frame.since_frame,
                          .model = c::span_from<sinew_affines>(frame.model),
                          .weights = c::span_from<sinew_floats>(frame.weights),
                          .properties = c::span_from<sinew_floats>(frame.properties),
                          .hidden = c::span_from<sinew_flags>(frame.hidden),
                          .instance_count = frame.instances.size(),
                          .shape_count = frame.primitives.size()},
                         out);
}

sinew_error sinew_world_of(const sinew_plan* plan, const sinew_result* result, std::uint32_t joint,
                           const sinew_affine* offset, sinew_affine* out) {
  if (plan == nullptr || result == nullptr || out == nullptr) return SINEW_NULL_ARGUMENT;
  const PlanAssets& assets = plan->plan.compiled()->assets;
  const std::span<const Affine> model = result_behind(result).model;
  if (joint >= assets.joint_map.size()) return SINEW_INDEX_OUT_OF_RANGE;
  if (model.empty()) return SINEW_UNSUPPORTED;
  if (model.size() != assets.joint_count()) return SINEW_SIZE_MISMATCH;
  Affine world = world_of(assets, model, joint);
  if (offset != nullptr) {
    Affine from_joint;
    c::copy_bits(*offset, from_joint);
    world = world * from_joint;
  }
  c::copy_bits(world, *out);
  return SINEW_OK;
}

sinew_joint_matrices sinew_get_palette(const sinew_result* result, std::uint32_t skin) {
  if (result == nullptr) return {nullptr, 0};
  const FrameResult& frame = result_behind(result);
  if (skin >= frame.palettes.size()) return {nullptr, 0};
  return c::span_from<sinew_joint_matrices>(frame.palettes[skin].matrices);
}

sinew_error sinew_get_instance_result(const sinew_result* result, std::uint32_t instance, sinew_instance_result* out) {
  if (result == nullptr) return SINEW_NULL_ARGUMENT;
  const FrameResult& frame = result_behind(result);
  if (instance >= frame.instances.size()) return SINEW_INDEX_OUT_OF_RANGE;
  const InstanceResult& found = frame.instances[instance];
  sinew_instance_result own{};
  c::copy_bits(found.world_from_mesh, own.world_from_mesh);
  c::copy_bits(found.bounds, own.bounds);
  own.first_shape = found.first_primitive;
  own.mirrored = found.mirrored;
  own.visible = found.visible;
  own.from_cache = found.from_cache;
  own.late = found.late;
  return c::write_struct(own, out);
}

sinew_error sinew_get_shape(const sinew_result* result, std::uint32_t shape, sinew_shape* out) {
  if (result == nullptr) return SINEW_NULL_ARGUMENT;
  const FrameResult& frame = result_behind(result);
  if (shape >= frame.primitives.size()) return SINEW_INDEX_OUT_OF_RANGE;
  const DeformedPrimitive& found = frame.primitives[shape];
  return c::write_struct({.struct_size = 0,
                          .instance = found.instance,
                          .primitive = found.primitive,
                          .positions = c::span_from<sinew_vec3s>(found.positions),
                          .normals = c::span_from<sinew_vec3s>(found.normals),
                          .tangents = c::span_from<sinew_vec4s>(found.tangents),
                          .colors = c::span_from<sinew_vec4s>(found.colors),
                          .since_frame = found.since_frame},
                         out);
}
