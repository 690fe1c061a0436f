// SPDX-License-Identifier: MIT
#include "tests/study/ray_caster.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <glm/geometric.hpp>

#include "importer/ambient/access_rays.h"
#include "importer/ambient/access_surfaces.h"
#include "importer/ambient/ray_scene.h"
#include "runtime/math/normal_transform.h"

namespace sinew::viewer {
namespace {

/// Normals at the corners of a triangle.
using CornerNormals = std::array<glm::vec3, 3>;

}  // namespace

struct RayCaster::State {
  explicit State(const std::vector<PlacedSurface>& surfaces) : triangles(triangles_of(surfaces)), scene(triangles) {}

  /// Fills `normals` beside the triangles that it returns.
  std::vector<RayTriangle> triangles_of(const std::vector<PlacedSurface>& surfaces) {
    std::vector<RayTriangle> all;
    for (const auto& [mesh, primitive, surface] : surfaces)
      for (std::size_t i = 0; surface.blocks && i < surface.indices.size(); i += 3) {
        RayTriangle triangle{{}, glm::dvec3(0.0), surface.both_sides};
        CornerNormals own{};
        for (std::size_t c = 0; c < 3; ++c) {
          triangle.corners[c] = surface.positions[surface.indices[i + c]];
          if (!surface.normals.empty()) own[c] = surface.normals[surface.indices[i + c]];
        }
        const glm::dvec3 first(triangle.corners[0]);
        triangle.normal =
            normalised_or(glm::cross(glm::dvec3(triangle.corners[1]) - first, glm::dvec3(triangle.corners[2]) - first),
                          glm::dvec3(0.0));
        if (triangle.normal == glm::dvec3(0.0)) continue;
        if (surface.normals.empty()) own.fill(glm::vec3(triangle.normal));
        all.push_back(triangle);
        normals.push_back(own);
      }
    return all;
  }

  std::vector<CornerNormals> normals;
  std::vector<RayTriangle> triangles;
  RayScene scene;
};

RayCaster::RayCaster(const Scene& scene, const FrameResult& frame)
    : state_(std::make_unique<State>(surfaces_of(scene, frame))) {}
RayCaster::~RayCaster() = default;

std::optional<RayCaster::Seen> RayCaster::seen(const glm::dvec3& from, const glm::dvec3& direction) const {
  const auto met = state_->scene.nearest(from, direction);
  if (!met) return std::nullopt;
  const RayTriangle& hit = state_->triangles[met->triangle];
  const double w = 1.0 - met->u - met->v;
  const auto between = [&](const auto& of) {
    return w * glm::dvec3(of[0]) + met->u * glm::dvec3(of[1]) + met->v * glm::dvec3(of[2]);
  };
  const glm::dvec3 geometric = glm::dot(direction, hit.normal) < 0.0 ? hit.normal : -hit.normal;
  const glm::dvec3 normal = normalised_or(between(state_->normals[met->triangle]), geometric);
  return Seen{between(hit.corners), glm::dot(normal, geometric) < 0.0 ? -normal : normal, geometric};
}

double RayCaster::open_share(const Seen& at, double radius_m, int ray_count) const {
  // Coordinates are floats: the start is moved off its triangle by more than their rounding errors.
  const double off = 0x1p-20 * (std::abs(at.point.x) + std::abs(at.point.y) + std::abs(at.point.z)) + 1e-5 * radius_m;
  const glm::dvec3 from = at.point + off * at.geometric;
  const AccessRays rays(at.normal, static_cast<std::uint32_t>(ray_count), {0.5, 0.0});
  std::vector<glm::dvec3> directions;
  for (int i = 0; i < ray_count; ++i) directions.push_back(rays.direction(static_cast<std::uint32_t>(i)));
  return static_cast<double>(state_->scene.open_count(from, directions, radius_m)) / ray_count;
}

}  // namespace sinew::viewer
