// SPDX-License-Identifier: MIT
#pragma once
#include "tests/reference/ssao.h"

namespace sinew::reference {

struct HorizonSettings {
  double radius = 0.5;
  int slices = 2;
  int steps = 6;  ///< on either side of a slice
  int step = 2;   ///< pixels from texel to texel
  double power = 1.0;
};

/// Ambient visibility by horizons, of a perspective.
/// eq   visibility = open^power
///      open = 1 - mean over slices of |m| times the integral of max(cos(h - g), 0) |sin h| over the angles h to the
///      line of sight that the horizons cover, by the midpoint rule; m = normal projected to the slice, g = its angle
///      to the line of sight. A horizon is the highest of the surfaces nearer than 1.3 radii and more than 0.02 of
///      their distance above the tangent plane, looked up at ((k + jitter) / steps)^1.5 of the radius and one pixel
///      farther. Its cosine to the line of sight is mixed with that of a free horizon, linearly from none of it at
///      0.95 radii to all at 1.3. The bent normal is the direction of 2/3 n - the same mean of the same integral,
///      times the unit direction at h and (1 - visibility) / (1 - open)
HalfVisibility horizon_visibility(const DepthAndNormals& image, const HorizonSettings& settings);

}  // namespace sinew::reference
