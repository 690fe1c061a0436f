// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "runtime/math/vectors.h"

namespace sinew::tool {

/// A path of the root over time.
struct RootPath {
  std::vector<double> times_s;             ///< increasing
  std::vector<Vec3<double>> translations;  ///< [times]

  /// Linear between times; the first and the last place outside of them. The origin for an empty path.
  Vec3<double> at(double time_s) const;
};

/// Reads {"times": [0, 0.5], "translations": [[0, 0, 0], [1, 0, 0]]}.
/// err   a sentence that names the file and the place in it
tl::expected<RootPath, std::string> read_root_path(const std::string& file);

}  // namespace sinew::tool
