// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

namespace sinew {

/// How far keys may be from what they are when a clip is compiled, so that they take fewer bits; 0 keeps them in full
/// float, bit for bit, and so does what is not named here. Only step and linear tracks are rounded.
struct KeyTolerances {
  struct OfBone {
    double translation = 0.0;  ///< a length
    double rotation = 0.0;     ///< the distance by which a point one unit from the axis moves: radians, for small ones
    double scale = 0.0;
  };
  std::vector<OfBone> bones;                 ///< parallel to Animation::bones, or empty
  std::vector<std::vector<double>> weights;  ///< [target_count] parallel to Animation::weights, or empty
};

}  // namespace sinew
