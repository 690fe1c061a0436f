// SPDX-License-Identifier: MIT
#include "importer/add_centers_of_rotation.h"

#include <algorithm>
#include <span>

namespace sinew {
namespace {

bool is_skinned(const Primitive& primitive) { return !primitive.influences.empty(); }

template <class T>
void append(std::vector<T>& all, const std::vector<T>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

/// Joins all skinned primitives of a mesh into one, with only the data that centers of rotation depend on. Vertices
/// follow each other in primitive order.
Primitive joined_surface(const Mesh& mesh) {
  Primitive all;
  for (const Primitive& p : mesh.primitives) {
    if (!is_skinned(p)) continue;
    const auto first_vertex = static_cast<std::uint32_t>(all.positions.size());
    const auto first_influence = static_cast<std::uint32_t>(all.influences.joints.size());
    append(all.positions, p.positions);
    append(all.influences.joints, p.influences.joints);
    append(all.influences.weights, p.influences.weights);
    for (InfluenceGroup group : p.influences.groups) {
      group.first_vertex += first_vertex;
      group.first_influence += first_influence;
      all.influences.groups.push_back(group);
    }
    if (p.topology != Topology::triangles) continue;
    for (const std::uint32_t i : p.indices) all.indices.push_back(first_vertex + i);
  }
  return all;
}

bool lacks_centers(const Mesh& mesh) {
  return std::any_of(mesh.primitives.begin(), mesh.primitives.end(),
                     [](const Primitive& p) { return is_skinned(p) && p.centers_of_rotation.empty(); });
}

/// Copies the centers of the joined surface to the primitives that have none.
void share_out(std::span<const glm::vec3> centers, Mesh& mesh) {
  for (Primitive& p : mesh.primitives) {
    if (!is_skinned(p)) continue;
    const auto own = centers.first(p.vertex_count());
    if (p.centers_of_rotation.empty()) p.centers_of_rotation.assign(own.begin(), own.end());
    centers = centers.subspan(own.size());
  }
}

std::vector<Mesh*> meshes_without_centers(Scene& scene) {
  std::vector<Mesh*> meshes;
  for (std::uint32_t m = 0; m < scene.meshes.size(); ++m) {
    const bool skinned = std::any_of(scene.instances.begin(), scene.instances.end(),
                                     [m](const MeshInstance& i) { return i.mesh == m && i.skin != kNone; });
    if (skinned && lacks_centers(scene.meshes[m])) meshes.push_back(&scene.meshes[m]);
  }
  return meshes;
}

}  // namespace

void add_centers_of_rotation(Scene& scene, const CentersOptions& options) {
  const std::vector<Mesh*> meshes = meshes_without_centers(scene);
  for (std::size_t m = 0; m < meshes.size(); ++m) {
    CentersOptions of_mesh = options;
    const auto report = [&](double done) {
      if (options.progress) options.progress((static_cast<double>(m) + done) / static_cast<double>(meshes.size()));
    };
    of_mesh.progress = report;
    share_out(centers_of_rotation(joined_surface(*meshes[m]), of_mesh), *meshes[m]);
    report(1.0);
  }
}

}  // namespace sinew
