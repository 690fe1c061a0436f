// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <span>

#include "runtime/model/scene.h"
#include "runtime/plan/frame_result.h"

namespace sinew::viewer {

/// The extreme points of a point cloud in 48 directions spread evenly over the sphere. The camera frames them instead
/// of a box, because a box has empty corners. A sphere extends beyond its 48 extreme points by less than 8 % of its
/// radius, which is within the margin of OrbitCamera::frame.
class Outline {
 public:
  static constexpr std::size_t kDirections = 48;

  Outline() noexcept;

  void add(const glm::vec3& point) noexcept;

  /// Adds the vertices of a frame that lie in `box`, the bounds of its triangles. Vertices outside belong to no
  /// triangle.
  /// in   origin  subtracted from each vertex
  /// cost O(vertices * directions)
  void add(const Scene& scene, const FrameResult& frame, const Aabb& box,
           const glm::vec3& origin = glm::vec3(0.0f)) noexcept;

  /// One extreme point for each direction; empty if no point was added.
  std::span<const glm::vec3> points() const noexcept { return {points_.data(), any_ ? kDirections : 0}; }

 private:
  std::array<glm::vec3, kDirections> directions_;
  std::array<float, kDirections> farthest_;
  std::array<glm::vec3, kDirections> points_{};
  bool any_ = false;
};

}  // namespace sinew::viewer
