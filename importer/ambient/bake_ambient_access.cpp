// SPDX-License-Identifier: MIT
#include "importer/ambient/bake_ambient_access.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <numeric>
#include <tuple>

#include <glm/geometric.hpp>

#include "importer/ambient/access_rays.h"
#include "importer/ambient/ray_scene.h"
#include "runtime/threads/default_executor.h"

namespace sinew {
namespace {

using Corners = std::array<glm::dvec3, 3>;

/// One triangle at one of its corners: rays begin there.
struct Face {
  glm::dvec3 start{0.0}, normal{0.0};
  double angle = 0.0;        ///< at the corner, radians
  std::uint64_t corner = 0;  ///< counted over the indices of all surfaces
};

Corners corners_of(const AccessSurface& surface, std::size_t triangle) {
  Corners corners;
  for (std::size_t c = 0; c < 3; ++c) corners[c] = glm::dvec3(surface.positions[surface.indices[3 * triangle + c]]);
  return corners;
}

/// Unit; zero for a triangle without area.
glm::dvec3 normal_of(const Corners& corners) {
  const glm::dvec3 n = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
  const double length = glm::length(n);
  return length > 0.0 ? n / length : glm::dvec3(0.0);
}

double angle_at(const Corners& corners, std::size_t c) {
  const glm::dvec3 a = corners[(c + 1) % 3] - corners[c], b = corners[(c + 2) % 3] - corners[c];
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// What tells vertices apart: place and normal, or the vertex itself where there are no normals.
using VertexKey = std::tuple<float, float, float, float, float, float, std::size_t>;

VertexKey key_of(const AccessSurface& surface, std::size_t vertex, std::size_t number) {
  const glm::vec3& p = surface.positions[vertex];
  if (surface.normals.empty()) return {p.x, p.y, p.z, 0.0f, 0.0f, 0.0f, number + 1};
  const glm::vec3& n = surface.normals[vertex];
  return {p.x, p.y, p.z, n.x, n.y, n.z, 0};
}

/// Gives vertices that are one the same number. Vertices are counted over all surfaces.
class SameVertices {
 public:
  explicit SameVertices(std::span<const AccessSurface> surfaces) {
    std::vector<VertexKey> keys;
    for (const AccessSurface& surface : surfaces) {
      first_.push_back(keys.size());
      for (std::size_t v = 0; v < surface.positions.size(); ++v) keys.push_back(key_of(surface, v, keys.size()));
    }
    std::vector<std::size_t> order(keys.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return keys[a] < keys[b]; });
    group_.resize(keys.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      count_ += i == 0 || keys[order[i - 1]] != keys[order[i]];
      group_[order[i]] = count_ - 1;
    }
  }

  std::size_t count() const noexcept { return count_; }
  std::size_t of(std::size_t surface, std::size_t vertex) const { return group_[first_[surface] + vertex]; }

 private:
  std::vector<std::size_t> first_, group_;
  std::size_t count_ = 0;
};

std::vector<std::vector<Face>> faces_of(std::span<const AccessSurface> surfaces, const SameVertices& vertices) {
  std::vector<std::vector<Face>> faces(vertices.count());
  std::uint64_t first_corner = 0;
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    const AccessSurface& surface = surfaces[s];
    for (std::size_t t = 0; 3 * t + 2 < surface.indices.size(); ++t) {
      const Corners corners = corners_of(surface, t);
      const glm::dvec3 normal = normal_of(corners), centroid = (corners[0] + corners[1] + corners[2]) / 3.0;
      if (normal == glm::dvec3(0.0)) continue;
      for (std::size_t c = 0; c < 3; ++c)
        faces[vertices.of(s, surface.indices[3 * t + c])].push_back(
            {access_start(corners[c], centroid, normal), normal, angle_at(corners, c), first_corner + 3 * t + c});
    }
    first_corner += surface.indices.size();
  }
  return faces;
}

std::vector<RayTriangle> blockers_of(std::span<const AccessSurface> surfaces) {
  std::vector<RayTriangle> triangles;
  for (const AccessSurface& surface : surfaces)
    for (std::size_t t = 0; surface.blocks && 3 * t + 2 < surface.indices.size(); ++t) {
      const Corners corners = corners_of(surface, t);
      const glm::dvec3 normal = normal_of(corners);
      if (normal == glm::dvec3(0.0)) continue;
      triangles.push_back(
          {{glm::vec3(corners[0]), glm::vec3(corners[1]), glm::vec3(corners[2])}, normal, surface.both_sides});
    }
  return triangles;
}

float access_of(const RayScene& blockers, std::span<const Face> faces, const AccessOptions& options,
                std::vector<glm::dvec3>& directions) {
  double open = 0.0, angles = 0.0;
  const auto rays = static_cast<std::uint32_t>(
      std::max<std::size_t>((options.rays + faces.size() - 1) / std::max<std::size_t>(faces.size(), 1), 1));
  directions.resize(rays);
  for (const Face& face : faces) {
    const AccessRays all(face.normal, rays, access_shift(options.seed, face.corner));
    for (std::uint32_t i = 0; i < rays; ++i) directions[i] = all.direction(i);
    const auto count = static_cast<double>(blockers.open_count(face.start, directions, options.distance_m));
    open += face.angle * (count / rays);
    angles += face.angle;
  }
  return angles > 0.0 ? static_cast<float>(open / angles) : 1.0f;
}

/// Access of the distinct vertices.
std::vector<float> cast_all(const RayScene& blockers, const std::vector<std::vector<Face>>& faces,
                            const AccessOptions& options) {
  constexpr std::size_t kBlock = 4096;  // of vertices between two reports
  std::vector<float> access(faces.size());
  for (std::size_t first = 0; first < faces.size(); first += kBlock) {
    const std::size_t end = std::min(faces.size(), first + kBlock);
    run_in_parallel(end - first, [&](std::size_t i) {
      thread_local std::vector<glm::dvec3> directions;  // keeps its memory from vertex to vertex
      access[first + i] = access_of(blockers, faces[first + i], options, directions);
    });
    if (options.progress) options.progress(static_cast<double>(end) / static_cast<double>(faces.size()));
  }
  return access;
}

}  // namespace

std::vector<std::vector<float>> bake_ambient_access(std::span<const AccessSurface> surfaces,
                                                    const AccessOptions& options) {
  const SameVertices vertices(surfaces);
  const RayScene blockers(blockers_of(surfaces));
  const std::vector<float> access = cast_all(blockers, faces_of(surfaces, vertices), options);
  std::vector<std::vector<float>> out(surfaces.size());
  for (std::size_t s = 0; s < surfaces.size(); ++s) {
    out[s].resize(surfaces[s].positions.size());
    for (std::size_t v = 0; v < out[s].size(); ++v) out[s][v] = access[vertices.of(s, v)];
  }
  return out;
}

}  // namespace sinew
