// SPDX-License-Identifier: MIT
#pragma once
#include "tests/reference/ssao.h"

namespace sinew::reference {

struct HorizonSettings {
  double radius = 0.5;
  int slices = 2;
  int steps = 6;  ///< on each side of a slice
  int step = 2;   ///< pixels from one texel of the half-size result to the next
  double power = 1.0;
};

/// Ambient visibility by horizons (GTAO) of a perspective picture.
/// eq   visibility = open^power
///      open = 1 - mean over slices of |m| times the integral of max(cos(h - g), 0) |sin h| over the angles h to the
///      line of sight that the horizons cover, by the midpoint rule; m = normal projected to the slice, g = its angle
///      to the line of sight.
///      A horizon is the highest surface found. Samples lie at ((k + jitter) / steps)^1.5 of the radius plus one pixel.
///      Only surfaces nearer than 1.3 radii count that lie above the tangent plane by over 0.02 of their distance.
///      The horizon's cosine to the line of sight fades linearly into that of a free horizon from 0.95 to 1.3 radii.
///      bent normal = direction of 2/3 n - (the same mean of the same integral, times the unit direction at h and
///      (1 - visibility) / (1 - open))
HalfVisibility horizon_visibility(const DepthAndNormals& image, const HorizonSettings& settings);

}  // namespace sinew::reference
