// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <vector>

#include "importer/file/document.h"
#include "importer/issue_log.h"
#include "runtime/model/scene.h"

namespace sinew {

/// Reads the lights of KHR_lights_punctual.
/// out      one entry for each light of the file, in file order; empty for a light of unknown type. Other invalid
///          values become the default
/// warning  light-values
std::vector<std::optional<Light>> read_lights(const gltf::Document& document, IssueLog& log);

}  // namespace sinew
