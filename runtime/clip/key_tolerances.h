// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

namespace sinew {

/// How far keys may be moved when a clip is compiled, so that they take fewer bits. 0, or no entry here, keeps the full
/// float bit for bit. Only step and linear tracks are rounded.
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
