// SPDX-License-Identifier: MIT
#include "viewer/app/inspect/pick.h"

#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

#include "viewer/app/inspect/frame_vertices.h"

namespace sinew::viewer {
namespace {

struct Hit {
  double distance = std::numeric_limits<double>::infinity();
  int corner = 0;
};

/// Keeps the hit if it is nearer than the one before. Returns true then.
bool meet(const Ray& ray, const glm::dvec3 (&p)[3], Hit& hit) {
  const glm::dvec3 a = p[1] - p[0], b = p[2] - p[0], normal = glm::cross(ray.along, b);
  const double determinant = glm::dot(a, normal);
  if (determinant == 0.0) return false;
  const glm::dvec3 to = ray.from - p[0];
  const double u = glm::dot(to, normal) / determinant;
  const glm::dvec3 other = glm::cross(to, a);
  const double v = glm::dot(ray.along, other) / determinant, distance = glm::dot(b, other) / determinant;
  if (!(u >= 0.0 && v >= 0.0 && u + v <= 1.0 && distance > 0.0 && distance < hit.distance)) return false;
  const double w = 1.0 - u - v;
  hit = {distance, w >= u && w >= v ? 0 : u >= v ? 1 : 2};
  return true;
}

}  // namespace

Ray ray_through(const View& view, double aspect, double x, double y) noexcept {
  const Affined& m = view.view_from_world;
  const auto to_world = [&](const glm::dvec3& v) {
    return glm::dvec3(m.row[0]) * v.x + glm::dvec3(m.row[1]) * v.y + glm::dvec3(m.row[2]) * v.z;
  };
  if (view.parallel()) {
    const glm::dvec3 aside = to_world({x * aspect * view.half_height_m, y * view.half_height_m, 0.0});
    return {eye_of(view) + aside, glm::normalize(to_world({0.0, 0.0, -1.0}))};
  }
  const double slope = std::tan(0.5 * view.fov_y_rad);
  return {eye_of(view), glm::normalize(to_world({x * aspect * slope, y * slope, -1.0}))};
}

std::optional<VertexPlace> pick_vertex(const Scene& scene, const FrameResult& frame, const Ray& ray) {
  std::optional<VertexPlace> picked;
  Hit hit;
  for_each_primitive(scene, frame, [&](std::size_t index, const Primitive& primitive, std::size_t instance) {
    if (primitive.topology != Topology::triangles) return;
    const auto positions = positions_of(frame, index, primitive);
    const auto world = affine_cast<double>(frame.instances[instance].world_from_mesh);
    for_each_copy(scene.instances[instance], world, [&](const Affined& world_from_copy) {
      for (std::size_t t = 0; t + 2 < primitive.indices.size(); t += 3) {
        glm::dvec3 corners[3];
        for (std::size_t c = 0; c < 3; ++c)
          corners[c] = transform_point(world_from_copy, glm::dvec3(positions[primitive.indices[t + c]]));
        if (!meet(ray, corners, hit)) continue;
        const auto of_mesh = index - frame.instances[instance].first_primitive;
        picked = VertexPlace{static_cast<std::uint32_t>(instance), static_cast<std::uint32_t>(of_mesh),
                             primitive.indices[t + static_cast<std::size_t>(hit.corner)]};
      }
    });
  });
  return picked;
}

glm::dvec3 position_of(const Scene& scene, const FrameResult& frame, const VertexPlace& vertex) {
  const MeshInstance& instance = scene.instances[vertex.instance];
  const InstanceResult& shown = frame.instances[vertex.instance];
  const auto positions = positions_of(frame, shown.first_primitive + vertex.primitive,
                                      scene.meshes[instance.mesh].primitives[vertex.primitive]);
  std::optional<glm::dvec3> at;
  for_each_copy(instance, affine_cast<double>(shown.world_from_mesh), [&](const Affined& world_from_copy) {
    if (!at) at = transform_point(world_from_copy, glm::dvec3(positions[vertex.vertex]));
  });
  return at.value_or(glm::dvec3(0.0));
}

std::vector<Influence> influences_of(const Scene& scene, const VertexPlace& vertex) {
  const MeshInstance& instance = scene.instances[vertex.instance];
  const VertexInfluences& of = scene.meshes[instance.mesh].primitives[vertex.primitive].influences;
  std::vector<Influence> influences;
  if (instance.skin == kNone || of.empty()) return {{instance.joint, 1.0f}};
  for (const InfluenceGroup& group : of.groups) {
    if (vertex.vertex < group.first_vertex || vertex.vertex >= group.first_vertex + group.vertex_count) continue;
    const std::size_t first =
        group.first_influence + std::size_t{vertex.vertex - group.first_vertex} * group.influence_count;
    for (std::size_t i = first; i < first + group.influence_count; ++i)
      influences.push_back({scene.skins[instance.skin].joints[of.joints[i]], of.weights[i]});
  }
  return influences;
}

}  // namespace sinew::viewer
