// SPDX-License-Identifier: MIT
#include "runtime/geometry_cache/scene_of_cache.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "runtime/base/contract.h"
#include "runtime/deform/surface_normals.h"
#include "runtime/math/quaternion.h"

namespace sinew {
namespace {

constexpr glm::vec3 kUp(0.0f, 1.0f, 0.0f);

std::vector<glm::vec3> values_of(GeometryDecoder& decoder, std::size_t stream, std::size_t vertex_count) {
  std::vector<glm::vec3> values(vertex_count);
  CONTRACT(decoder.write_vertices(stream, values) == GeometryStatus::ok);
  return values;
}

/// Smooth over the points of the positions.
std::vector<glm::vec3> smooth_normals(const Primitive& primitive, const GeometryStream& positions) {
  const SurfaceFaces faces{primitive.indices, positions.point_of_vertex, positions.point_count, {}};
  std::vector<glm::vec4> sums(surface_sums(faces));
  std::vector<glm::vec3> normals(primitive.vertex_count());
  const std::vector<glm::vec3> up(primitive.vertex_count(), kUp);
  run_unchecked(SurfaceNormalsJob{
      .faces = &faces, .positions = primitive.positions, .rest_normals = up, .sums = sums, .normals = normals});
  return normals;
}

/// in   stream  the first one of the mesh
Primitive primitive_of(const GeometryMesh& mesh, std::size_t stream, GeometryDecoder& decoder) {
  Primitive out;
  out.indices = mesh.triangles;
  if (mesh.triangles.empty()) {
    out.topology = Topology::points;
    out.indices.resize(mesh.vertex_count);
    std::iota(out.indices.begin(), out.indices.end(), 0u);
  }
  for (const GeometryStream& info : mesh.streams) {
    std::vector<glm::vec3> values = values_of(decoder, stream++, mesh.vertex_count);
    switch (info.kind) {
      case GeometryKind::positions: out.positions = std::move(values); break;
      case GeometryKind::normals:
        for (glm::vec3& n : values) n = normalised_or(n, kUp);
        out.normals = std::move(values);
        break;
      case GeometryKind::colors:
        for (const glm::vec3& c : values) out.colors.emplace_back(glm::clamp(c, 0.0f, 1.0f), 1.0f);
        break;
    }
  }
  if (out.normals.empty() && out.topology == Topology::triangles) out.normals = smooth_normals(out, mesh.streams[0]);
  return out;
}

void add_mesh(CacheScene& out, const GeometryMesh& mesh, Primitive primitive) {
  Scene& scene = out.scene;
  const auto index = static_cast<std::uint32_t>(scene.meshes.size());
  scene.skeleton.parents.push_back(kNone);
  scene.skeleton.rest.emplace_back();
  scene.skeleton.fixed_matrix_of.push_back(kNone);
  scene.skeleton.names.push_back(mesh.name);
  scene.skeleton.node_of_joint.push_back(index);
  scene.skeleton.joint_of_node.push_back(index);
  primitive.material = index;
  Material& material = scene.materials.emplace_back();
  material.name = mesh.name;
  material.metallic = 0.0f;
  material.double_sided = true;
  Mesh& made = scene.meshes.emplace_back();
  made.name = mesh.name;
  made.primitives.push_back(std::move(primitive));
  scene.instances.push_back({.joint = index, .mesh = index});
  out.bindings.push_back({index, 0, index});
}

}  // namespace

tl::expected<CacheScene, GeometryStatus> scene_of(const GeometryCache& cache, FrameSource frames) {
  GeometryDecoder decoder(cache);
  if (const GeometryStatus status = decoder.decode(0, frames); status != GeometryStatus::ok)
    return tl::unexpected(status);
  CacheScene out;
  std::size_t stream = 0;
  for (const GeometryMesh& mesh : cache.meshes()) {
    add_mesh(out, mesh, primitive_of(mesh, stream, decoder));
    stream += mesh.streams.size();
  }
  out.scene.skeleton.level_begin = {0};
  if (!cache.meshes().empty())
    out.scene.skeleton.level_begin.push_back(static_cast<std::uint32_t>(cache.meshes().size()));
  finish_scene(out.scene);
  return out;
}

}  // namespace sinew
