// SPDX-License-Identifier: MIT
#pragma once
#include <limits>

#include <vulkan/vulkan.h>
#include <glm/vec2.hpp>

#include "viewer/passes/view.h"

namespace sinew::viewer {

/// A rectangle of the picture that holds all that is drawn, so that passes over pixels leave the rest out. Normalised
/// device coordinates: -1 to 1 from left to right and from top to bottom.
class CoveredArea {
 public:
  CoveredArea() = default;
  /// in   aspect  width / height of the picture
  CoveredArea(const View& view, double aspect) noexcept;

  /// Adds a point of view space. A point that is not in front of the near plane may end up anywhere.
  void add_point(const glm::dvec3& point) noexcept;
  /// Adds what a box may cover; an empty box stands for unknown bounds.
  void add_box(const Affined& view_from_box, const Aabb& box) noexcept;
  void add_everything() noexcept;

  /// The texels of an image over the picture that lie on the area or beside it.
  /// in   picture  pixels;   step  pixels of the picture for a texel, along each axis; the last texel may have fewer
  /// out  no texels where nothing was added
  VkRect2D texels(VkExtent2D picture, std::uint32_t step) const noexcept;

 private:
  glm::dvec2 scale_{};  ///< of x and y, over the distance in a perspective view
  double near_m_ = 0.0;
  bool parallel_ = false;
  glm::dvec2 least_{std::numeric_limits<double>::infinity()}, most_{-std::numeric_limits<double>::infinity()};
};

}  // namespace sinew::viewer
