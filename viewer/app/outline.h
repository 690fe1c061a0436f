// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <span>

#include "runtime/model/scene.h"
#include "runtime/plan/frame_result.h"

namespace sinew::viewer {

/// The outermost points of a cloud in directions spread evenly over the sphere: enough to frame it tightly, because
/// boxes have empty corners.
/// err  a ball reaches less than 8 percent of its radius beyond them: inside the margin that framing leaves
class Outline {
 public:
  static constexpr std::size_t kDirections = 48;

  Outline() noexcept;

  void add(const glm::vec3& point) noexcept;

  /// All vertices of a frame that lie in its box; others belong to no triangle.
  /// cost O(vertices * directions)
  void add(const Scene& scene, const FrameResult& frame, const Aabb& box) noexcept;

  /// Empty before the first point.
  std::span<const glm::vec3> points() const noexcept { return {points_.data(), any_ ? kDirections : 0}; }

 private:
  std::array<glm::vec3, kDirections> directions_;
  std::array<float, kDirections> farthest_;
  std::array<glm::vec3, kDirections> points_{};
  bool any_ = false;
};

}  // namespace sinew::viewer
