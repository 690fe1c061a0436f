// SPDX-License-Identifier: MIT
#include "tests/study/seen_pixels.h"

#include <cmath>

#include "runtime/base/contract.h"

namespace sinew::viewer {

SeenPixels seen_pixels(const RayCaster& rays, const View& view, std::uint32_t width, std::uint32_t height) {
  CONTRACT(!view.parallel());
  const glm::dvec3 eye = eye_of(view);
  const double slope_y = std::tan(0.5 * view.fov_y_rad), slope_x = slope_y * width / height;
  SeenPixels seen{width, height, {}};
  seen.pixels.reserve(std::size_t{width} * height);
  for (std::uint32_t y = 0; y < height; ++y)
    for (std::uint32_t x = 0; x < width; ++x) {
      const glm::dvec3 in_view((2.0 * (x + 0.5) / width - 1.0) * slope_x, (1.0 - 2.0 * (y + 0.5) / height) * slope_y,
                               -1.0);
      glm::dvec3 direction(0.0);  // the rotation of the view: its inverse is its transpose
      for (int r = 0; r < 3; ++r) direction += in_view[r] * glm::dvec3(view.view_from_world.row[r]);
      seen.pixels.push_back(rays.seen(eye, direction));
    }
  return seen;
}

}  // namespace sinew::viewer
