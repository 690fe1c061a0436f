// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>

#include "runtime/assets/clip_layout.h"

namespace sinew {

/// Where the values of one block of tracks go: planes `plane_stride` floats apart, a lane's place is the block's target.
struct TrackOutput {
  float* first_plane = nullptr;
  std::size_t plane_stride = 0;

  float* plane(std::size_t component) const noexcept { return first_plane + component * plane_stride; }
};

/// Everything that all tracks of a group share between two keys: fractions and Hermite weights, from double (N24).
struct BetweenKeys {
  std::size_t key;
  float s, r;                       ///< fraction of the interval, and 1 - s
  float value0, out0, value1, in1;  ///< weights of the Hermite form, those of tangents times the interval

  explicit BetweenKeys(const KeyPosition& at) noexcept
      : key(at.key), s(static_cast<float>(at.fraction)), r(static_cast<float>(1.0 - at.fraction)) {
    const double t = at.fraction, u = 1.0 - t;
    value0 = static_cast<float>((1.0 + 2.0 * t) * (u * u));
    out0 = static_cast<float>(at.interval_s * (t * (u * u)));
    value1 = static_cast<float>(t * t * (3.0 - 2.0 * t));
    in1 = static_cast<float>(-at.interval_s * (t * t * u));
  }
};

inline std::size_t component_count(Property property) noexcept {
  return property == Property::weight ? 1 : property == Property::rotation ? 4 : 3;
}

}  // namespace sinew
