// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "viewer/light/cube_map.h"

namespace sinew::viewer {

/// Radiance from all around in one picture.
/// eq   columns go around from -x over -z, +x in the middle, and +z back to -x; rows from +y down to -y, in equal angles
struct Panorama {
  std::uint32_t width = 0, height = 0;
  std::vector<glm::vec3> texels;  ///< [width * height] linear
};

/// Reads Radiance (.hdr) or OpenEXR (.exr), whichever the bytes are.
/// err  one sentence: another format, damaged, not twice as wide as high, wider than 8192
tl::expected<Panorama, std::string> decode_panorama(std::span<const std::byte> bytes);

/// The panorama on the faces of a cube; each texel is the mean of what it covers.
/// in   size  texels along an edge
CubeMap cube_from(const Panorama& panorama, std::uint32_t size);

}  // namespace sinew::viewer
