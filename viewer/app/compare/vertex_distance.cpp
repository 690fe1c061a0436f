// SPDX-License-Identifier: MIT
#include "viewer/app/compare/vertex_distance.h"

#include <algorithm>

#include <glm/geometric.hpp>

#include "runtime/math/affine.h"
#include "viewer/app/inspect/frame_vertices.h"
#include "viewer/app/inspect/paint.h"

namespace sinew::viewer {

VertexDistances vertex_distances(const Scene& scene, const FrameResult& a, const FrameResult& b) {
  VertexDistances out;
  out.primitives.resize(a.primitives.size());
  double sum = 0.0, worst = -1.0;
  for_each_primitive(scene, a, [&](std::size_t index, const Primitive& primitive, std::size_t instance) {
    out.primitives[index].assign(primitive.vertex_count(), 0.0f);
    if (!b.instances[instance].visible) return;
    const auto in_a = positions_of(a, index, primitive), in_b = positions_of(b, index, primitive);
    const auto world_a = affine_cast<double>(a.instances[instance].world_from_mesh),
               world_b = affine_cast<double>(b.instances[instance].world_from_mesh);
    for (std::size_t v = 0; v < in_a.size(); ++v) {
      const double distance = glm::length(transform_point(world_a, Vec3<double>(in_a[v])) -
                                          transform_point(world_b, Vec3<double>(in_b[v])));
      out.primitives[index][v] = static_cast<float>(distance);
      sum += distance;
      if (distance <= worst) continue;
      worst = distance;
      out.worst_primitive = static_cast<std::uint32_t>(index);
      out.worst_vertex = static_cast<std::uint32_t>(v);
    }
    out.vertices += in_a.size();
  });
  out.worst_m = std::max(worst, 0.0);
  out.mean_m = out.vertices > 0 ? sum / static_cast<double>(out.vertices) : 0.0;
  return out;
}

Scene painted_scene(const Scene& scene, const FrameResult& frame, const VertexDistances& distances, double full_m) {
  std::vector<std::vector<std::vector<float>>> shares(scene.meshes.size());
  for (std::size_t m = 0; m < scene.meshes.size(); ++m)
    for (const Primitive& primitive : scene.meshes[m].primitives) shares[m].emplace_back(primitive.vertex_count());
  for_each_primitive(scene, frame, [&](std::size_t index, const Primitive&, std::size_t instance) {
    std::vector<float>& of_mesh =
        shares[scene.instances[instance].mesh][index - frame.instances[instance].first_primitive];
    for (std::size_t v = 0; v < of_mesh.size(); ++v)
      of_mesh[v] = std::max(of_mesh[v], static_cast<float>(distances.primitives[index][v] / full_m));
  });
  return painted_by_shares(scene, shares);
}

}  // namespace sinew::viewer
