// SPDX-License-Identifier: MIT
#include "viewer/passes/draw_list.h"

#include <algorithm>

#include "runtime/math/determinant_sign.h"
#include "runtime/model/scene.h"
#include "viewer/passes/frame_renderer.h"

namespace sinew::viewer {

namespace {

struct Source {
  VkBuffer own, deformed;
};

void bind_attributes(Draw& draw, const MeshSet& meshes, const PrimitiveBuffers& own, const DeformedBuffers& deformed,
                     const Source& source) {
  const std::array<VkDeviceSize, kAttributeCount> moved = {
      deformed.positions, deformed.normals, deformed.tangents, kAbsent, kAbsent, deformed.colors, kAbsent, kAbsent};
  for (std::size_t a = 0; a < kAttributeCount; ++a) {
    const bool is_moved = moved[a] != kAbsent, is_own = own.attributes[a] != kAbsent;
    draw.buffers[a] = is_moved ? source.deformed : source.own;
    draw.offsets[a] = is_moved ? moved[a] : is_own ? own.attributes[a] : meshes.default_of(static_cast<Attribute>(a));
    draw.strides[a] = is_moved || is_own ? kAttributeBytes[a] : 0;
  }
}

/// Points the visibility attributes to the key poses before and after the frame's time.
void choose_key_poses(Draw& draw, const PrimitiveBuffers& own, std::size_t vertices, const VisibilityBlend& blend) {
  const auto visibility = static_cast<std::size_t>(Attribute::visibility);
  if (own.attributes[visibility] == kAbsent) return;
  draw.offsets[visibility] += VkDeviceSize{kAttributeBytes[visibility]} * vertices * blend.pose;
  draw.offsets[visibility + 1] += VkDeviceSize{kAttributeBytes[visibility]} * vertices * blend.next;
}

/// Range of distances of a box from the eye plane.
DepthRange range_of(const Affine& view_from_box, const Aabb& box) {
  const glm::vec4 row = view_from_box.row[2];
  const glm::vec3 middle = 0.5f * (box.lower + box.upper), half = 0.5f * (box.upper - box.lower);
  const float distance = -(glm::dot(glm::vec3(row), middle) + row.w), reach = glm::dot(glm::abs(glm::vec3(row)), half);
  return {distance - reach, distance + reach};
}

/// Number of draw calls of an instance, copies included.
std::uint32_t draws_of(const MeshInstance& instance, const Mesh& mesh) {
  const auto drawn = std::count_if(mesh.primitives.begin(), mesh.primitives.end(),
                                   [](const Primitive& p) { return !p.indices.empty(); });
  return static_cast<std::uint32_t>(static_cast<std::size_t>(drawn) * std::max<std::size_t>(instance.copies.size(), 1));
}

SurfaceFeatures surface_of(const Primitive& primitive, const MaterialFeatures& material) {
  SurfaceFeatures surface;
  surface.material = material;
  if (primitive.topology != Topology::triangles) return surface;
  if (!primitive.normals.empty()) surface.normals = NormalSource::vertices;
  if (primitive.flat_normals) surface.normals = NormalSource::faces;
  surface.tangents = !primitive.tangents.empty();
  return surface;
}

Caster caster_of(const Draw& draw, const DrawnScene& drawn, const FrameVertices& vertices,
                 const DeformedBuffers& deformed, const Affined& world_from_mesh) {
  Caster caster{draw, world_from_mesh, drawn.scene->number(), drawn.variant, 0, 1};
  const bool deforms = deformed.positions != kAbsent;
  if (deforms || draw.masked) caster.source = vertices.source;
  if (deforms) caster.since = deformed.since;
  if (draw.masked) caster.since = vertices.frame;  // its material may be animated
  return caster;
}

}  // namespace

void DrawList::collect(std::span<const DrawnScene> scenes, std::uint32_t slot, const View& view, double aspect,
                       float point_size, bool casters, Transparency transparency) {
  opaque_.clear();
  blended_.clear();
  weighted_.clear();
  opaque_area_ = drawn_area_ = CoveredArea(view, aspect);
  standing_ = {};
  unbounded_ = false;
  weighted_range_ = {};
  casters_.clear();
  unlit_ = reads_table_ = false;
  hidden_ = out_of_view_ = 0;
  const Frame frame{slot, view, aspect, point_size, casters, transparency};
  for (const DrawnScene& drawn : scenes) {
    const FrameVertices& vertices = drawn.frame->vertices(slot);
    const Scene& scene = drawn.scene->scene();
    for (std::size_t i = 0; i < vertices.instances.size(); ++i) {
      const PlacedInstance& placed = vertices.instances[i];
      hidden_ += placed.hidden;
      if (!placed.visible && !placed.hidden)
        out_of_view_ += draws_of(scene.instances[i], scene.meshes[scene.instances[i].mesh]);
      if (!placed.visible) continue;
      const bool copied = !scene.instances[i].copies.empty();
      for_each_copy(scene.instances[i], affine_cast<double>(placed.world_from_mesh),
                    [&](const Affined& world_from_copy) {
                      // The view matrix never mirrors.
                      const bool mirrored = copied ? determinant_sign(world_from_copy) < 0 : placed.mirrored;
                      add(frame, drawn, i, world_from_copy, mirrored);
                    });
    }
  }
  std::stable_sort(blended_.begin(), blended_.end(),
                   [](const Draw& a, const Draw& b) { return a.distance > b.distance; });
}

void DrawList::add(const Frame& frame, const DrawnScene& drawn, std::size_t instance, const Affined& world_from_mesh,
                   bool mirrored) {
  const Affined view_from_mesh_d = frame.view.view_from_world * world_from_mesh;
  const FrameVertices& vertices = drawn.frame->vertices(frame.slot);
  const Scene& scene = drawn.scene->scene();
  const MeshSet& meshes = drawn.scene->meshes();
  const Affine view_from_mesh = affine_cast<float>(view_from_mesh_d),
               view_from_world = affine_cast<float>(frame.view.view_from_world);
  const Aabb& bounds = vertices.instances[instance].bounds;
  const std::uint32_t mesh_index = scene.instances[instance].mesh;
  const Mesh& mesh = scene.meshes[mesh_index];
  for (std::uint32_t p = 0; p < mesh.primitives.size(); ++p) {
    const Primitive& primitive = mesh.primitives[p];
    const PrimitiveBuffers& own = meshes.primitive(mesh_index, p);
    if (own.index_count == 0) continue;
    const DeformedBuffers& deformed = vertices.primitives[vertices.instances[instance].first_primitive + p];
    const bool moved = deformed.positions != kAbsent;  // deformed: only the bounds of the whole instance are known
    const bool out_of_view = moved ? is_out_of_view(frame.view, frame.aspect, frame.view.view_from_world, bounds)
                                   : is_out_of_view(frame.view, frame.aspect, view_from_mesh_d, primitive.bounds);
    out_of_view_ += out_of_view;
    if (out_of_view && !frame.casters) continue;
    const std::uint32_t material_index = material_of(primitive, drawn.variant);
    const Material* material = material_index == kNone ? nullptr : &scene.materials[material_index];
    const AlphaMode alpha = material ? material->alpha_mode : AlphaMode::opaque;
    Draw draw;
    bind_attributes(draw, meshes, own, deformed, {meshes.buffer(), vertices.buffer.handle()});
    choose_key_poses(draw, own, primitive.vertex_count(), drawn.visibility);
    draw.indices = meshes.buffer();
    draw.indices_at = own.indices;
    draw.index_count = own.index_count;
    draw.material = drawn.scene->materials().set_of(material_index, frame.slot);
    draw.constants = {{view_from_mesh.row[0], view_from_mesh.row[1], view_from_mesh.row[2]},
                      mirrored ? -1.0f : 1.0f,
                      frame.point_size,
                      drawn.visibility.factor};
    draw.surface = surface_of(primitive, drawn.scene->materials().features_of(material_index));
    draw.surface.double_sided = material && material->double_sided;
    draw.topology = primitive.topology;
    draw.masked = alpha == AlphaMode::mask;
    draw.mirrored = mirrored;
    draw.distance = -transform_point(view_from_mesh, deformed.centre).z;
    draw.blended = alpha == AlphaMode::blend;
    draw.transmits = draw.surface.material.layers.transmission && draw.surface.normals != NormalSource::none;
    draw.frosted = draw.transmits && material && (material->roughness > 0.0f || draw.surface.material.layers.volume);
    const bool sorted = material && shows_behind(*material);
    const bool casts = frame.casters && !sorted && primitive.topology == Topology::triangles;
    const Affined& world_from_bounds = moved ? Affined{} : world_from_mesh;
    if (!sorted && (casts || !out_of_view)) add_standing(world_from_bounds, moved ? bounds : primitive.bounds);
    if (casts) casters_.push_back(caster_of(draw, drawn, vertices, deformed, world_from_mesh));
    unlit_ = unlit_ || (!out_of_view && draw.surface.material.unlit);
    const LayerFeatures& layers = draw.surface.material.layers;
    reads_table_ = reads_table_ || (!out_of_view && (layers.sheen || layers.transmission));
    if (out_of_view) continue;
    if (draw.topology == Topology::points)
      drawn_area_.add_everything();  // points extend beyond their bounds
    else
      drawn_area_.add_box(moved ? frame.view.view_from_world : view_from_mesh_d, moved ? bounds : primitive.bounds);
    if (sorted && !draw.transmits && frame.transparency == Transparency::weighted)
      add_weighted(draw, moved && !bounds.empty() ? range_of(view_from_world, bounds)
                         : moved                  ? DepthRange{draw.distance, draw.distance}
                                                  : range_of(view_from_mesh, primitive.bounds));
    else if (sorted)
      blended_.push_back(draw);
    else
      add_opaque(draw, moved ? frame.view.view_from_world : view_from_mesh_d, moved ? bounds : primitive.bounds);
  }
}

void DrawList::add_standing(const Affined& world_from_bounds, const Aabb& bounds) {
  if (bounds.empty()) unbounded_ = true;
  for (int c = 0; c < 8 && !bounds.empty(); ++c)
    standing_.add(glm::vec3(transform_point(
        world_from_bounds, glm::dvec3(c & 1 ? bounds.upper.x : bounds.lower.x, c & 2 ? bounds.upper.y : bounds.lower.y,
                                      c & 4 ? bounds.upper.z : bounds.lower.z))));
}

void DrawList::add_opaque(const Draw& draw, const Affined& view_from_bounds, const Aabb& bounds) {
  if (draw.topology == Topology::points)
    opaque_area_.add_everything();  // points extend beyond their bounds
  else
    opaque_area_.add_box(view_from_bounds, bounds);
  opaque_.push_back(draw);
}

void DrawList::add_weighted(const Draw& draw, const DepthRange& range) {
  const DepthRange before = weighted_.empty() ? range : weighted_range_;
  weighted_range_ = {std::min(before.nearest_m, range.nearest_m), std::max(before.farthest_m, range.farthest_m)};
  weighted_.push_back(draw);
}

}  // namespace sinew::viewer
