// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec3.hpp>

namespace sinew {

/// A triangle that blocks rays. World space, counter-clockwise seen from its front.
struct RayTriangle {
  glm::vec3 corners[3];
  glm::dvec3 normal{0.0};   ///< unit normal of the front
  bool both_sides = false;  ///< false = rays pass through from behind
};

/// Casts rays against triangles with Embree. Rays may be cast from any thread.
class RayScene {
 public:
  /// err  std::runtime_error if Embree runs out of memory
  explicit RayScene(std::vector<RayTriangle> triangles);
  ~RayScene();

  struct Hit {
    std::uint32_t triangle = 0;
    double u = 0.0, v = 0.0;  ///< weights of the second and third corner
  };

  /// The nearest triangle hit by a ray.
  std::optional<Hit> nearest(const glm::dvec3& from, const glm::dvec3& direction) const;

  /// Number of rays that hit no triangle within `distance_m`, which may be infinite.
  /// in   directions  unit
  /// cost rays are cast in packets of eight
  std::size_t open_count(const glm::dvec3& from, std::span<const glm::dvec3> directions, double distance_m) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sinew
