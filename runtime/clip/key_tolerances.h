// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

namespace sinew {

/// How far compile_clip may round keys, so that they take fewer bits. A tolerance of 0, or no entry, keeps the full
/// float. Only step and linear tracks are rounded.
struct KeyTolerances {
  struct OfBone {
    double translation = 0.0;  ///< in metres
    double rotation = 0.0;  ///< the distance by which a point one unit from the axis moves; for small angles, radians
    double scale = 0.0;
  };
  std::vector<OfBone> bones;                 ///< parallel to Animation::bones, or empty
  std::vector<std::vector<double>> weights;  ///< [target_count] parallel to Animation::weights, or empty
};

}  // namespace sinew
