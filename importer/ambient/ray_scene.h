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
  glm::dvec3 normal{0.0};   ///< unit, of the front
  bool both_sides = false;  ///< false: rays pass through the back
};

/// Triangles that rays are cast against, by Embree. Rays from any thread.
class RayScene {
 public:
  /// err  std::runtime_error when Embree has no memory
  explicit RayScene(std::vector<RayTriangle> triangles);
  ~RayScene();

  struct Hit {
    std::uint32_t triangle = 0;
    double u = 0.0, v = 0.0;  ///< weights of the second and third corner
  };

  /// The nearest triangle that a ray meets.
  std::optional<Hit> nearest(const glm::dvec3& from, const glm::dvec3& direction) const;

  /// How many rays meet no triangle nearer than `distance_m`, which may be infinite.
  /// in   directions  unit
  /// cost rays go in packets of eight
  std::size_t open_count(const glm::dvec3& from, std::span<const glm::dvec3> directions, double distance_m) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sinew
