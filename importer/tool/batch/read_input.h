// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "importer/import_gltf.h"

namespace sinew::tool {

/// Imports a file, or the standard input if the name is "-": a .glb, or a .gltf whose buffers are data URIs.
/// err   as import_gltf()
ImportResult<ImportedFile> read_input(const std::string& file, const ImportOptions& options);

}  // namespace sinew::tool
