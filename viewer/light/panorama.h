// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "viewer/light/cube_map.h"

namespace sinew::viewer {

/// An equirectangular (latitude-longitude) map of radiance.
/// eq   columns run from -x over -z, +x (the middle) and +z back to -x; rows from +y to -y; both in equal angles
struct Panorama {
  std::uint32_t width = 0, height = 0;
  std::vector<glm::vec3> texels;  ///< [width * height] linear
};

/// Reads a Radiance (.hdr) or OpenEXR (.exr) file; the format is detected from the bytes.
/// err  one sentence: unknown format, damaged, not twice as wide as high, or wider than 8192
tl::expected<Panorama, std::string> decode_panorama(std::span<const std::byte> bytes);

/// Resamples the panorama to a cube map; each texel is the mean over its area.
/// in   size  texels along an edge
CubeMap cube_from(const Panorama& panorama, std::uint32_t size);

}  // namespace sinew::viewer
