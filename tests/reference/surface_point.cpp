// SPDX-License-Identifier: MIT
#include "tests/reference/surface_point.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <type_traits>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace sinew::reference {
namespace {

/// One triangle of an instance, with its corners in world space.
struct Triangle {
  const Scene& scene;
  const Primitive& primitive;
  const DeformedPrimitive& deformed;
  Affined world_from_mesh;
  bool mirrored;
  std::array<std::size_t, 3> vertex;
  std::array<glm::dvec3, 3> corner;
};

/// Weighted sum of a vertex attribute over the corners of the triangle.
template <class Values, class Convert>
auto mixed(const Triangle& triangle, const glm::dvec3& share, const Values& values, const Convert& convert) {
  return convert(values[triangle.vertex[0]]) * share[0] + convert(values[triangle.vertex[1]]) * share[1] +
         convert(values[triangle.vertex[2]]) * share[2];
}

glm::dvec3 normal_at(const Triangle& triangle, const glm::dvec3& share) {
  const auto& corner = triangle.corner;
  if (triangle.primitive.flat_normals)
    return glm::normalize(glm::cross(corner[1] - corner[0], corner[2] - corner[0])) * (triangle.mirrored ? -1.0 : 1.0);
  if (triangle.primitive.normals.empty()) return glm::dvec3(0.0);
  const glm::dmat3 turn = glm::transpose(glm::inverse(linear_part(triangle.world_from_mesh)));
  const auto turned = [&](const glm::vec3& n) { return glm::normalize(turn * glm::dvec3(n)); };
  const std::span<const glm::vec3> own = triangle.primitive.normals;
  return glm::normalize(
      mixed(triangle, share, triangle.deformed.normals.empty() ? own : triangle.deformed.normals, turned));
}

/// Tangent frame from the mesh's stored tangents.
TangentFrame stored_frame(const Triangle& triangle, const glm::dvec3& share, const glm::dvec3& normal) {
  const auto moved = [&](const glm::vec4& t) {
    return glm::dvec4(transform_vector(triangle.world_from_mesh, glm::dvec3(t)), t.w);
  };
  const glm::dvec4 t = mixed(triangle, share, triangle.primitive.tangents, moved);
  const glm::dvec3 tangent = glm::normalize(glm::dvec3(t) - normal * glm::dot(normal, glm::dvec3(t)));
  return {tangent, t.w * glm::cross(normal, tangent) * (triangle.mirrored ? -1.0 : 1.0)};
}

/// Tangent frame from positions and texture coordinates. The tangent runs along dP/du; w puts the bitangent on the side
/// where v falls.
/// eq   [edge 1, edge 2] = [dP/du, dP/dv] * [duv 1, duv 2]
TangentFrame derived_frame(const Triangle& triangle, std::size_t set, const glm::dvec3& normal) {
  if (triangle.primitive.texcoords.size() <= set) return {};
  const auto uv = [&](int c) { return glm::dvec2(triangle.primitive.texcoords[set][triangle.vertex[c]]); };
  const glm::dvec3 e1 = triangle.corner[1] - triangle.corner[0], e2 = triangle.corner[2] - triangle.corner[0];
  const glm::dvec2 d1 = uv(1) - uv(0), d2 = uv(2) - uv(0);
  const double area = d1.x * d2.y - d2.x * d1.y;
  const glm::dvec3 along_u = (e1 * d2.y - e2 * d1.y) / area, along_v = (e2 * d1.x - e1 * d2.x) / area;
  const glm::dvec3 tangent = glm::normalize(along_u - normal * glm::dot(normal, along_u));
  const glm::dvec3 aside = glm::cross(normal, tangent);
  return {tangent, glm::dot(aside, along_v) < 0.0 ? aside : -aside};
}

/// Where the line meets the plane of a triangle: weights of the corners, and t along the line.
struct Meeting {
  glm::dvec3 share;
  double t;
};

std::optional<Meeting> meet(const Triangle& triangle, const SightLine& line) {
  const glm::dvec3 e1 = triangle.corner[1] - triangle.corner[0], e2 = triangle.corner[2] - triangle.corner[0];
  const double volume = glm::determinant(glm::dmat3(e1, e2, -line.direction));
  if (volume == 0.0) return std::nullopt;
  const glm::dvec3 found = glm::inverse(glm::dmat3(e1, e2, -line.direction)) * (line.from - triangle.corner[0]);
  const glm::dvec3 share(1.0 - found.x - found.y, found.x, found.y);
  if (share.x < 0.0 || share.y < 0.0 || share.z < 0.0) return std::nullopt;
  return Meeting{share, found.z};
}

void add_point(const Triangle& triangle, const SightLine& line, std::vector<SurfacePoint>& points) {
  const std::optional<Meeting> meeting = meet(triangle, line);
  if (!meeting) return;
  const auto& corner = triangle.corner;
  SurfacePoint point;
  if (triangle.primitive.material != kNone) point.material = triangle.scene.materials[triangle.primitive.material];
  const double facing = glm::dot(glm::cross(corner[1] - corner[0], corner[2] - corner[0]), -line.direction);
  point.front = (facing > 0.0) != triangle.mirrored;
  if (!point.front && !point.material.double_sided) return;
  point.distance_m = meeting->t;
  point.position = line.from + line.direction * meeting->t;
  point.to_viewer = -glm::normalize(line.direction);
  const glm::dvec3 share = meeting->share;
  const auto in_double = [](const auto& v) { return glm::vec<std::decay_t<decltype(v)>::length(), double>(v); };
  for (std::size_t set = 0; set < std::min<std::size_t>(triangle.primitive.texcoords.size(), 2); ++set)
    point.uv[set] = mixed(triangle, share, triangle.primitive.texcoords[set], in_double);
  if (!triangle.primitive.colors.empty()) point.color = mixed(triangle, share, triangle.primitive.colors, in_double);
  point.normal = normal_at(triangle, share);
  point.scale = std::cbrt(std::abs(determinant(triangle.world_from_mesh)));
  if (point.material.reads_tangents())
    for (std::size_t set = 0; set < point.frames.size(); ++set)
      point.frames[set] = triangle.primitive.tangents.empty() ? derived_frame(triangle, set, point.normal)
                                                              : stored_frame(triangle, share, point.normal);
  points.push_back(point);
}

}  // namespace

std::vector<SurfacePoint> surfaces_along(const Scene& scene, const FrameResult& frame, const SightLine& line) {
  std::vector<SurfacePoint> points;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const Affined world = affine_cast<double>(frame.instances[i].world_from_mesh);
    const auto& primitives = scene.meshes[scene.instances[i].mesh].primitives;
    for (std::size_t p = 0; p < primitives.size(); ++p) {
      const Primitive& primitive = primitives[p];
      const DeformedPrimitive& deformed = frame.primitives[frame.instances[i].first_primitive + p];
      const std::span<const glm::vec3> own = primitive.positions;
      const auto positions = deformed.positions.empty() ? own : deformed.positions;
      for (std::size_t k = 0; k + 2 < primitive.indices.size(); k += 3) {
        Triangle triangle{scene, primitive, deformed, world, determinant(world) < 0.0, {}, {}};
        for (std::size_t c = 0; c < 3; ++c) {
          triangle.vertex[c] = primitive.indices[k + c];
          triangle.corner[c] = transform_point(world, glm::dvec3(positions[triangle.vertex[c]]));
        }
        add_point(triangle, line, points);
      }
    }
  }
  std::stable_sort(points.begin(), points.end(),
                   [](const SurfacePoint& a, const SurfacePoint& b) { return a.distance_m < b.distance_m; });
  return points;
}

}  // namespace sinew::reference
