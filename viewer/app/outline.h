// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <span>

#include "runtime/model/scene.h"
#include "runtime/plan/frame_result.h"

namespace sinew::viewer {

/// The extreme points of a point cloud in 48 directions spread evenly over the sphere. The camera frames them instead
/// of a box, because a box has empty corners. A ball reaches less than 8 percent of its radius beyond its extreme
/// points, which is within the margin that OrbitCamera::frame leaves.
class Outline {
 public:
  static constexpr std::size_t kDirections = 48;

  Outline() noexcept;

  void add(const glm::vec3& point) noexcept;

  /// Adds the vertices of a frame that lie in `box`, the box of what is drawn; other vertices belong to no triangle.
  /// in   origin  is taken from each
  /// cost O(vertices * directions)
  void add(const Scene& scene, const FrameResult& frame, const Aabb& box,
           const glm::vec3& origin = glm::vec3(0.0f)) noexcept;

  /// One extreme point for each direction; empty before the first point.
  std::span<const glm::vec3> points() const noexcept { return {points_.data(), any_ ? kDirections : 0}; }

 private:
  std::array<glm::vec3, kDirections> directions_;
  std::array<float, kDirections> farthest_;
  std::array<glm::vec3, kDirections> points_{};
  bool any_ = false;
};

}  // namespace sinew::viewer
