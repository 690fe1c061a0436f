// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>

#include "runtime/clip/clip_layout.h"

namespace sinew {

/// Where one block of tracks is written: planes `plane_stride` floats apart. A track writes to its target index in each
/// plane.
struct TrackOutput {
  float* first_plane = nullptr;
  std::size_t plane_stride = 0;

  float* plane(std::size_t component) const noexcept { return first_plane + component * plane_stride; }
};

/// Position between two keys. All tracks of a group share it.
struct BetweenKeys {
  std::size_t key;
  double fraction, interval_s;
  float s, r;  ///< fraction of the interval, and 1 - fraction

  explicit BetweenKeys(const KeyPosition& at) noexcept
      : key(at.key),
        fraction(at.fraction),
        interval_s(at.interval_s),
        s(static_cast<float>(at.fraction)),
        r(static_cast<float>(1.0 - at.fraction)) {}
};

/// The two packed keys that a sample lies between. `begin` points to the row of the earlier key, `end` to that of the
/// later one. A row holds the packed values of all tracks of a block at one key. Exactly at a key both are its row.
struct PackedKeys {
  const std::uint8_t *begin, *end;
  float s, r;         ///< share of the later key and of the earlier one
  std::size_t power;  ///< the highest power of the slerp series that these keys need (slerp_series.h)
};

/// Weights of the cubic Hermite form. Tangent weights include the interval. Computed in double and rounded to float
/// once.
struct HermiteWeights {
  float value0, out0, value1, in1;

  explicit HermiteWeights(const BetweenKeys& at) noexcept {
    const double t = at.fraction, u = 1.0 - t;
    value0 = static_cast<float>((1.0 + 2.0 * t) * (u * u));
    out0 = static_cast<float>(at.interval_s * (t * (u * u)));
    value1 = static_cast<float>(t * t * (3.0 - 2.0 * t));
    in1 = static_cast<float>(-at.interval_s * (t * t * u));
  }
};

/// True for translation, rotation and scale tracks. Their targets are joint indices; targets of weights and properties
/// are consecutive.
inline bool moves_joints(Property property) noexcept { return property < Property::weight; }

inline std::size_t component_count(Property property) noexcept {
  switch (property) {
    case Property::rotation: return 4;
    case Property::translation:
    case Property::scale: return 3;
    case Property::weight:
    case Property::number: break;
  }
  return 1;
}

}  // namespace sinew
