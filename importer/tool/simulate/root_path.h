// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "runtime/math/vectors.h"

namespace sinew::tool {

/// Positions of the character's root over time.
struct RootPath {
  std::vector<double> times_s;             ///< increasing
  std::vector<Vec3<double>> translations;  ///< [times]

  /// Position at `time_s`: linear between keys, the first or last position outside of them. The origin if there are
  /// none.
  Vec3<double> at(double time_s) const;
};

/// Reads {"times": [0, 0.5], "translations": [[0, 0, 0], [1, 0, 0]]}.
/// err   a sentence that names the file and the place in it
tl::expected<RootPath, std::string> read_root_path(const std::string& file);

}  // namespace sinew::tool
