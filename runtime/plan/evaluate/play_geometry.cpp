// SPDX-License-Identifier: MIT
#include "runtime/plan/evaluate/play_geometry.h"

#include <algorithm>

#include "runtime/deform/surface_normals.h"
#include "runtime/math/determinant_sign.h"
#include "runtime/math/normal_transform.h"

namespace sinew {
namespace {

/// True if the instance is unskinned and its source gives vertices in mesh space. Pose and source are then blended in
/// that space.
bool blends_in_mesh_space(const CompiledPlan& plan, std::size_t instance, VertexSpace space) noexcept {
  return space == VertexSpace::mesh && !plan.instance_skinned[instance];
}

/// Writes the vertices of a source, and computes the normals and tangents that the source lacks.
void write_source(const CompiledPlan& plan, std::size_t p, const VertexSource& source, bool turned,
                  const VertexOutput& out, FrameMemory memory, FrameWork& work) noexcept {
  const PrimitivePlan& planned = plan.primitives[p];
  const Primitive& primitive = primitive_of(plan, planned);
  const bool has_normals =
      source.write(source.context, planned.instance, planned.primitive, out.positions, out.normals);
  work.vertices_from_cache += primitive.vertex_count();
  const SurfaceFaces* const faces = plan.surface_faces[p].get();
  if (faces == nullptr) {  // points and lines keep normals and tangents of the rest mesh
    if (!has_normals) std::copy_n(primitive.normals.begin(), out.normals.size(), out.normals.begin());
    std::copy_n(primitive.tangents.begin(), out.tangents.size(), out.tangents.begin());
    return;
  }
  const bool derives_normals = !has_normals && !out.normals.empty();
  if (derives_normals)
    run_unchecked(SurfaceNormalsJob{.faces = faces,
                                    .positions = out.positions,
                                    .rest_normals = primitive.normals,
                                    .turned = turned,
                                    .sums = memory.of(plan.layout.surface_sums.part(0, surface_sums(*faces))),
                                    .normals = out.normals});
  if (!out.tangents.empty())
    run_unchecked(SurfaceTangentsJob{
        .faces = faces, .positions = out.positions, .rest_tangents = primitive.tangents, .tangents = out.tangents});
  if (derives_normals || !out.tangents.empty()) work.smooth_triangles += faces->count();
}

/// Moves vertices to the space in which they are blended.
struct Mover {
  explicit Mover(const Affine& m)
      : matrix(m), cofactors(cofactor(Mat3<double>(linear_part(m))) * (determinant_sign(m) < 0 ? -1.0 : 1.0)) {}

  glm::vec3 position(const glm::vec3& x) const noexcept { return transform_point(matrix, x); }
  /// As transform_normal_outward.
  glm::vec3 normal(const glm::vec3& n) const noexcept {
    const Vec3<double> exact(n);
    return glm::vec3(normalised_or(cofactors * exact, exact));
  }
  glm::vec3 tangent(const glm::vec4& t) const noexcept {
    return normalised_or(transform_vector(matrix, glm::vec3(t)), glm::vec3(t));
  }

  const Affine& matrix;
  const Mat3<double> cofactors;  ///< cofactor matrix times the sign of the determinant
};

/// Blends vertices of the pose with vertices of a source.
struct GeometryBlend {
  float weight;
  Mover pose, source;

  /// eq   (1 - w) A x + w B y
  glm::vec3 position(const glm::vec3& x, const glm::vec3& y) const noexcept {
    return (1.0f - weight) * pose.position(x) + weight * source.position(y);
  }
  /// eq   normalise((1 - w) a + w b), a and b unit
  glm::vec3 normal(const glm::vec3& x, const glm::vec3& y) const noexcept {
    return mix(pose.normal(x), source.normal(y));
  }
  glm::vec4 tangent(const glm::vec4& x, const glm::vec4& y) const noexcept {
    return glm::vec4(mix(pose.tangent(x), source.tangent(y)), x.w);
  }

 private:
  glm::vec3 mix(const glm::vec3& a, const glm::vec3& b) const noexcept {
    return normalised_or((1.0f - weight) * a + weight * b, b);
  }
};

void blend(const GeometryBlend& with, const DeformedPrimitive& pose, const VertexOutput& source,
           const VertexOutput& out) noexcept {
  for (std::size_t v = 0; v < out.positions.size(); ++v)
    out.positions[v] = with.position(pose.positions[v], source.positions[v]);
  for (std::size_t v = 0; v < out.normals.size(); ++v) out.normals[v] = with.normal(pose.normals[v], source.normals[v]);
  for (std::size_t v = 0; v < out.tangents.size(); ++v)
    out.tangents[v] = with.tangent(pose.tangents[v], source.tangents[v]);
}

}  // namespace

void show_sources(const CompiledPlan& plan, std::span<const GeometryInput> geometry, const Visibility& visibility,
                  const FrameTables& tables, FrameWork& work) noexcept {
  for (std::size_t slot = 0; slot < tables.shown.size(); ++slot) {
    const std::uint32_t instance = plan.needs.in.cached_instances[slot];
    tables.shown[slot] = {};
    if (geometry.empty() || !geometry[slot].plays() || geometry_slot_of(plan, instance) == kNone) continue;
    if (!visibility.is_deformed(plan, instance)) continue;
    const VertexSource& source = geometry[slot].source;
    tables.shown[slot] = source.show(source.context, instance, geometry[slot].time_s);
    work.cache_frames_decoded += tables.shown[slot].frames_decoded;
    work.spent_on(Stage::geometry_cache);
  }
}

PlayedGeometry place_geometry(const CompiledPlan& plan, std::size_t instance, const GeometryInput& geometry,
                              const ShownVertices& shown, const Affine& world_from_joint, const Affine& root,
                              int root_sign, InstanceResult& placed) noexcept {
  PlayedGeometry played;
  if (!geometry.plays()) return played;
  placed.late = shown.is_late;
  placed.from_cache = shown.is_there;
  if (!shown.is_there) return played;
  const VertexSpace space = geometry.source.space;
  const Affine& world_from_source = space == VertexSpace::scene ? root : world_from_joint;
  played.weight = geometry.weight;
  played.space = space;
  played.turned = space == VertexSpace::scene && placed.mirrored != (root_sign < 0);
  played.content = geometry.source.content;
  played.moment = shown.moment;
  if (played.in_full()) {
    placed.world_from_mesh = world_from_source;
    if (space == VertexSpace::mesh) placed.mirrored = determinant_sign(world_from_joint) < 0;
  } else if (!blends_in_mesh_space(plan, instance, space)) {
    played.world_from_source = world_from_source;
    played.world_from_pose = placed.world_from_mesh;
    placed.world_from_mesh = {};
  }
  return played;
}

DeformedPrimitive play_primitive(const CompiledPlan& plan, std::size_t p, const VertexSource& source,
                                 const PlayedGeometry& played, const InstancePose& pose, FrameMemory memory,
                                 FrameWork& work) noexcept {
  const PrimitivePlan& planned = plan.primitives[p];
  const Primitive& primitive = primitive_of(plan, planned);
  const VertexOutput out = output_in(memory, planned.cached, plan.layout.primitives[p], primitive.vertex_count());
  DeformedPrimitive shape;
  bool turned = played.turned;
  if (played.in_full()) {
    shape.instance = planned.instance;
    shape.primitive = planned.primitive;
    if (planned.morph_colors) shape.colors = primitive.colors;
    write_source(plan, p, source, turned, out, memory, work);
  } else {
    shape = deform_primitive(plan, p, pose, false, memory, work);
    const VertexOutput from = output_in(memory, planned.cached, plan.layout.cached, primitive.vertex_count());
    write_source(plan, p, source, turned, from, memory, work);
    blend({played.weight, Mover(played.world_from_pose), Mover(played.world_from_source)}, shape, from, out);
    work.vertices_blended += primitive.vertex_count();
    turned = pose.mirrored && !blends_in_mesh_space(plan, planned.instance, played.space);
  }
  work.spent_on(Stage::geometry_cache);
  shape.positions = out.positions;
  shape.normals = out.normals;
  shape.tangents = out.tangents;
  if (planned.flat_normals) shape.normals = flatten_primitive(plan, p, out.positions, turned, memory, work);
  return shape;
}

}  // namespace sinew
