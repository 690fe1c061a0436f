// SPDX-License-Identifier: MIT
#include "runtime/c/result.h"

#include <cstddef>
#include <span>

#include "runtime/c/glue/call.h"
#include "runtime/c/glue/convert.h"
#include "runtime/c/glue/pose_span.h"
#include "runtime/c/glue/struct_versions.h"
#include "runtime/c/handles.h"
#include "runtime/deform/write_vertices.h"
#include "runtime/plan/compiled_plan.h"
#include "runtime/plan/frame_result.h"

using namespace sinew;

namespace {

const FrameResult& result_behind(const sinew_result* result) noexcept {
  return *reinterpret_cast<const FrameResult*>(result);
}

/// The attributes of a buffer as an output of WriteVerticesJob or QuantizeVerticesJob.
template <class Output>
Output output_over(const sinew_vertex_buffer& to) noexcept {
  return {{static_cast<std::byte*>(to.positions), to.positions ? to.vertex_count : 0, to.position_stride},
          {static_cast<std::byte*>(to.normals), to.normals ? to.vertex_count : 0, to.normal_stride},
          {static_cast<std::byte*>(to.tangents), to.tangents ? to.vertex_count : 0, to.tangent_stride}};
}

ErrorCode write_shape(const DeformedPrimitive& shape, const sinew_vertex_buffer& to) noexcept {
  const VertexInput vertices{.positions = shape.positions, .normals = shape.normals, .tangents = shape.tangents};
  const auto lacks = [](const void* wanted, std::size_t count) { return wanted != nullptr && count == 0; };
  if (lacks(to.positions, vertices.positions.size()) || lacks(to.normals, vertices.normals.size()) ||
      lacks(to.tangents, vertices.tangents.size()))
    return ErrorCode::unsupported;
  switch (to.format) {
    case SINEW_VERTEX_FLOAT: return run(WriteVerticesJob{vertices, output_over<StridedOutput>(to)});
    case SINEW_VERTEX_16_BIT: {
      Aabb box;
      c::copy_bytes(to.box, box);
      return run(QuantizeVerticesJob{vertices, box, output_over<QuantizedOutput>(to)});
    }
    default: return ErrorCode::unsupported;
  }
}

}  // namespace

sinew_error sinew_get_result(const sinew_result* result, sinew_result_info* out) {
  return c::call(c::given(result), [&] {
    const FrameResult& frame = result_behind(result);
    return c::write_struct({.struct_size = 0,
                            .frame = frame.frame,
                            .since_frame = frame.since_frame,
                            .model = c::to_c(frame.model),
                            .weights = c::to_c(frame.weights),
                            .properties = c::to_c(frame.properties),
                            .hidden = c::to_c(frame.hidden),
                            .instance_count = frame.instances.size(),
                            .shape_count = frame.primitives.size(),
                            .local = c::to_c(frame.local)},
                           out);
  });
}

sinew_error sinew_world_of(const sinew_plan* plan, const sinew_result* result, std::uint32_t joint,
                           const sinew_affine* offset, sinew_affine* out) {
  return c::call(c::given(plan, result, out), [&] {
    const PlanAssets& assets = plan->plan.compiled()->assets;
    const std::span<const Affine> model = result_behind(result).model;
    if (joint >= assets.joint_map.size()) return SINEW_INDEX_OUT_OF_RANGE;
    if (model.empty()) return SINEW_UNSUPPORTED;
    if (model.size() != assets.joint_count()) return SINEW_SIZE_MISMATCH;
    const Affine world = world_of(assets, model, joint);
    Affine from_joint;
    if (offset != nullptr) c::copy_bytes(*offset, from_joint);
    *out = c::to_c(offset != nullptr ? world * from_joint : world);
    return SINEW_OK;
  });
}

sinew_joint_matrices sinew_get_palette(const sinew_result* result, std::uint32_t skin) {
  if (result == nullptr || skin >= result_behind(result).palettes.size()) return {nullptr, 0};
  return c::to_c(result_behind(result).palettes[skin].matrices);
}

sinew_error sinew_get_instance_result(const sinew_result* result, std::uint32_t instance, sinew_instance_result* out) {
  return c::call(c::given(result), [&] {
    const std::span<const InstanceResult> instances = result_behind(result).instances;
    if (instance >= instances.size()) return SINEW_INDEX_OUT_OF_RANGE;
    const InstanceResult& found = instances[instance];
    return c::write_struct({.struct_size = 0,
                            .world_from_mesh = c::to_c(found.world_from_mesh),
                            .bounds = c::to_c(found.bounds),
                            .first_shape = found.first_primitive,
                            .mirrored = found.mirrored,
                            .visible = found.visible,
                            .from_cache = found.from_cache,
                            .late = found.late},
                           out);
  });
}

sinew_error sinew_get_shape(const sinew_result* result, std::uint32_t shape, sinew_shape* out) {
  return c::call(c::given(result), [&] {
    const std::span<const DeformedPrimitive> shapes = result_behind(result).primitives;
    if (shape >= shapes.size()) return SINEW_INDEX_OUT_OF_RANGE;
    const DeformedPrimitive& found = shapes[shape];
    return c::write_struct({.struct_size = 0,
                            .instance = found.instance,
                            .primitive = found.primitive,
                            .positions = c::to_c(found.positions),
                            .normals = c::to_c(found.normals),
                            .tangents = c::to_c(found.tangents),
                            .colors = c::to_c(found.colors),
                            .since_frame = found.since_frame},
                           out);
  });
}

sinew_error sinew_write_shape(const sinew_result* result, std::uint32_t shape, const sinew_vertex_buffer* to) {
  return c::call(c::given(result, to), [&] {
    const std::span<const DeformedPrimitive> shapes = result_behind(result).primitives;
    if (shape >= shapes.size()) return SINEW_INDEX_OUT_OF_RANGE;
    sinew_vertex_buffer buffer{};
    if (const sinew_error error = c::read_struct(to, buffer); error != SINEW_OK) return error;
    return c::error_from(write_shape(shapes[shape], buffer));
  });
}
