// SPDX-License-Identifier: MIT
#include "viewer/app/pictures/outline.h"

#include <cmath>
#include <limits>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "runtime/model/scene.h"

namespace sinew::viewer {

// Directions of a spherical Fibonacci lattice: equal steps in y, each rotated by the golden angle.
Outline::Outline() noexcept {
  const double turn = std::numbers::pi * (3.0 - std::sqrt(5.0));
  for (std::size_t i = 0; i < kDirections; ++i) {
    const double y = 1.0 - 2.0 * (static_cast<double>(i) + 0.5) / kDirections;
    const double radius = std::sqrt(1.0 - y * y), angle = turn * static_cast<double>(i);
    directions_[i] = glm::vec3(glm::dvec3(radius * std::cos(angle), y, radius * std::sin(angle)));
  }
  farthest_.fill(-std::numeric_limits<float>::infinity());
}

void Outline::add(const glm::vec3& point) noexcept {
  any_ = true;
  for (std::size_t i = 0; i < kDirections; ++i) {
    const float along = glm::dot(directions_[i], point);
    if (along <= farthest_[i]) continue;
    farthest_[i] = along;
    points_[i] = point;
  }
}

void Outline::add(const Scene& scene, const FrameResult& frame, const Aabb& box, const glm::vec3& origin) noexcept {
  for (std::size_t i = 0; i < frame.instances.size(); ++i) {
    const InstanceResult& instance = frame.instances[i];
    if (!instance.visible) continue;
    const Mesh& mesh = scene.meshes[scene.instances[i].mesh];
    for (std::size_t p = 0; p < mesh.primitives.size(); ++p) {
      const DeformedPrimitive& deformed = frame.primitives[instance.first_primitive + p];
      const std::span<const glm::vec3> positions =
          deformed.positions.empty() ? mesh.primitives[p].positions : deformed.positions;
      for_each_copy(scene.instances[i], instance.world_from_mesh, [&](const Affine& world_from_copy) {
        for (const auto& position : positions) {
          const glm::vec3 point = transform_point(world_from_copy, position);
          if (glm::all(glm::lessThanEqual(box.lower, point)) && glm::all(glm::lessThanEqual(point, box.upper)))
            add(point - origin);
        }
      });
    }
  }
}

}  // namespace sinew::viewer
