// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>

#include <tl/expected.hpp>

#include "importer/tool/command.h"
#include "importer/tool/poses/compare_poses.h"

namespace sinew::tool {

/// The tolerances of `sinew verify` as texts of the command line.
struct ToleranceOptions {
  std::optional<std::string> distance, normals, weights, matrices;
};

/// Adds --tolerance and the options for normals, weights and matrices.
void add_tolerance_options(Command& command, ToleranceOptions& options);

/// Reads the tolerances from the texts of the options.
/// err   a sentence for the user that names the option
tl::expected<PoseTolerance, std::string> parse_tolerance(const ToleranceOptions& options, double model_size_m);

}  // namespace sinew::tool
