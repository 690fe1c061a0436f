// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/importer/tool_model.h"

namespace sinew::test {

inline constexpr const char* kNoValidator =
    "no gltf-validator: install the npm package and name its folder in SINEW_GLTF_VALIDATOR";

/// Issues that the npm package gltf-validator finds in each file: {file: [[code, pointer and message], ...]}. It also
/// reads buffers and images of the file.
/// in    folder         folder for the validator's input files
///       most_severity  0 = errors alone, 3 = also warnings, infos and hints
/// out   empty if the validator is not installed
std::optional<nlohmann::json> issues_by_validator(const ToolModelFile& folder, const std::vector<std::string>& files,
                                                  int most_severity);

}  // namespace sinew::test
