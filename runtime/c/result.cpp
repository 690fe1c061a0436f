// SPDX-License-Identifier: MIT
#include "runtime/c/result.h"

#include <span>

#include "runtime/c/boundary.h"
#include "runtime/c/handles.h"
#include "runtime/plan/compiled_plan.h"
#include "runtime/plan/frame_result.h"

using namespace sinew;

namespace {

const FrameResult& result_behind(const sinew_result* result) noexcept {
  return *reinterpret_cast<const FrameResult*>(result);
}

}  // namespace

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
                          .shape_count = frame.primitives.size(),
                          .local = {frame.local.planes, frame.local.joint_count}},
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
