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

/// What the npm package gltf-validator finds in each file: {file: [[code, pointer and message], ...]}. Buffers and
/// images beside a file are read, too.
/// in    folder         keeps what is written for the validator
///       most_severity  0 = errors alone, 3 = also warnings, infos and hints
/// out   nothing where the validator is not installed
std::optional<nlohmann::json> issues_by_validator(const ToolModelFile& folder, const std::vector<std::string>& files,
                                                  int most_severity);

}  // namespace sinew::test
