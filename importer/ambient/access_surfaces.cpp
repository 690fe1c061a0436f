// SPDX-License-Identifier: MIT
#include "importer/ambient/access_surfaces.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "runtime/math/determinant_sign.h"
#include "runtime/math/normal_transform.h"
#include "runtime/model/scene.h"

namespace sinew {
namespace {

AccessSurface surface_of(const Primitive& primitive, const DeformedPrimitive& deformed, const Affined& world_from_mesh,
                         bool mirrored) {
  const std::span<const glm::vec3> positions =
      deformed.positions.empty() ? std::span<const glm::vec3>(primitive.positions) : deformed.positions;
  const std::span<const glm::vec3> normals =
      deformed.normals.empty() ? std::span<const glm::vec3>(primitive.normals) : deformed.normals;
  const Mat3<double> linear = linear_part(world_from_mesh);
  AccessSurface surface;
  for (const glm::vec3& p : positions) surface.positions.emplace_back(transform_point(world_from_mesh, glm::dvec3(p)));
  if (!primitive.flat_normals)
    for (const glm::vec3& n : normals) surface.normals.emplace_back(transform_normal_outward(linear, glm::dvec3(n)));
  surface.indices = primitive.indices;
  surface.indices.resize(surface.indices.size() / 3 * 3);
  for (std::size_t i = 0; mirrored && i < surface.indices.size(); i += 3)
    std::swap(surface.indices[i], surface.indices[i + 2]);
  return surface;
}

void add_mean(const std::vector<float>& access, std::size_t placements, std::vector<float>& mean) {
  mean.resize(access.size(), 0.0f);
  for (std::size_t v = 0; v < access.size(); ++v) mean[v] += access[v] / static_cast<float>(placements);
}

}  // namespace

std::vector<PlacedSurface> surfaces_of(const Scene& scene, const FrameResult& frame) {
  std::vector<PlacedSurface> surfaces;
  for (std::size_t i = 0; i < frame.instances.size(); ++i) {
    const InstanceResult& placed = frame.instances[i];
    const MeshInstance& instance = scene.instances[i];
    if (!placed.visible) continue;
    const Mesh& mesh = scene.meshes[instance.mesh];
    for_each_copy(instance, affine_cast<double>(placed.world_from_mesh), [&](const Affined& world_from_copy) {
      const bool mirrored = instance.copies.empty() ? placed.mirrored : determinant_sign(world_from_copy) < 0;
      for (std::uint32_t p = 0; p < mesh.primitives.size(); ++p) {
        const Primitive& primitive = mesh.primitives[p];
        if (primitive.topology != Topology::triangles) continue;
        const Material* material = primitive.material == kNone ? nullptr : &scene.materials[primitive.material];
        PlacedSurface made{
            instance.mesh, p,
            surface_of(primitive, frame.primitives[placed.first_primitive + p], world_from_copy, mirrored)};
        made.surface.both_sides = material && material->double_sided;
        made.surface.blocks = !material || material->alpha_mode != AlphaMode::blend;
        surfaces.push_back(std::move(made));
      }
    });
  }
  return surfaces;
}

double default_access_distance_m(const Scene& scene, const FrameResult& frame) {
  Aabb box;
  for (const PlacedSurface& placed : surfaces_of(scene, frame))
    for (const glm::vec3& p : placed.surface.positions) box.add(p);
  if (box.empty()) return std::numeric_limits<double>::infinity();
  const glm::dvec3 sides = glm::dvec3(box.upper) - glm::dvec3(box.lower);
  return 0.25 * std::max({sides.x, sides.y, sides.z});
}

MeshAccess bake_mesh_access(const Scene& scene, const FrameResult& frame, const AccessOptions& options) {
  std::vector<PlacedSurface> placed = surfaces_of(scene, frame);
  MeshAccess access(scene.meshes.size());
  std::vector<std::vector<std::size_t>> placements(scene.meshes.size());
  for (std::size_t m = 0; m < scene.meshes.size(); ++m) {
    access[m].resize(scene.meshes[m].primitives.size());
    placements[m].resize(scene.meshes[m].primitives.size());
  }
  std::vector<AccessSurface> surfaces;
  for (PlacedSurface& one : placed) {
    ++placements[one.mesh][one.primitive];
    surfaces.push_back(std::move(one.surface));
  }
  const std::vector<std::vector<float>> baked = bake_ambient_access(surfaces, options);
  for (std::size_t s = 0; s < baked.size(); ++s)
    add_mean(baked[s], placements[placed[s].mesh][placed[s].primitive], access[placed[s].mesh][placed[s].primitive]);
  return access;
}

}  // namespace sinew
