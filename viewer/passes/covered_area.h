// SPDX-License-Identifier: MIT
#pragma once
#include <limits>

#include <vulkan/vulkan.h>
#include <glm/vec2.hpp>

#include "viewer/passes/view.h"

namespace sinew::viewer {

/// A conservative screen rectangle of everything drawn; full-screen passes skip the rest. Stored in normalised device
/// coordinates: -1 to 1 from left to right and from top to bottom.
class CoveredArea {
 public:
  CoveredArea() = default;
  /// in   aspect  width / height of the picture
  CoveredArea(const View& view, double aspect) noexcept;

  /// Adds a point in view space. A point behind the near plane adds the whole picture.
  void add_point(const glm::dvec3& point) noexcept;
  /// Adds the area of a box. An empty box means unknown bounds and adds the whole picture.
  void add_box(const Affined& view_from_box, const Aabb& box) noexcept;
  void add_everything() noexcept;

  /// The area in texels of an image of the picture, with a margin of one texel.
  /// in   picture  pixels;   step  pixels per texel along each axis; the last texel may have fewer
  /// out  an empty rectangle if nothing was added
  VkRect2D texels(VkExtent2D picture, std::uint32_t step) const noexcept;

 private:
  glm::dvec2 scale_{};  ///< projection scale of x and y; divided by the distance in a perspective view
  double near_m_ = 0.0;
  bool parallel_ = false;
  glm::dvec2 least_{std::numeric_limits<double>::infinity()}, most_{-std::numeric_limits<double>::infinity()};
};

}  // namespace sinew::viewer
