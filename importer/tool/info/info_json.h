// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "importer/import_gltf.h"
#include "importer/tool/json.h"

namespace sinew::tool {

/// Everything that `sinew info` says about a file, as one JSON document. The text is made from it.
/// in    file   imported with carry_document, so that the document tells what `sinew convert` would lose
Json info_json(const std::string& name, const ImportedFile& file);

}  // namespace sinew::tool
