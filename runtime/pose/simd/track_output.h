// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>

#include "runtime/clip/clip_layout.h"

namespace sinew {

/// Where the values of one block of tracks go: planes `plane_stride` floats apart, a lane's place is the block's
/// target.
struct TrackOutput {
  float* first_plane = nullptr;
  std::size_t plane_stride = 0;

  float* plane(std::size_t component) const noexcept { return first_plane + component * plane_stride; }
};

/// What all tracks of a group share between two keys.
struct BetweenKeys {
  std::size_t key;
  double fraction, interval_s;
  float s, r;  ///< fraction of the interval, and 1 - s

  explicit BetweenKeys(const KeyPosition& at) noexcept
      : key(at.key),
        fraction(at.fraction),
        interval_s(at.interval_s),
        s(static_cast<float>(at.fraction)),
        r(static_cast<float>(1.0 - at.fraction)) {}
};

/// Rows of the two keys of packed tracks that a time lies between; on a key that one twice.
struct PackedKeys {
  const std::uint8_t *begin, *end;
  float s, r;
};

/// Weights of the Hermite form, those of tangents times the interval, from double (N24).
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

/// Otherwise the targets of a block are neighbours.
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
