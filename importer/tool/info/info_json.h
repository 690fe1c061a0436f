// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "importer/import_gltf.h"
#include "importer/tool/json.h"

namespace sinew::tool {

/// Everything that `sinew info` says about a file, as one JSON document. The text is made from it.
/// in    file          imported with carry_document, so that the document tells what `sinew convert` would lose
///       not_carried   for a file imported without carry_document: why it cannot be converted
Json info_json(const std::string& name, const ImportedFile& file, const std::vector<ImportIssue>& not_carried = {});

}  // namespace sinew::tool
