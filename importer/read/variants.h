// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "importer/file/document.h"
#include "importer/issue_log.h"
#include "runtime/model/mesh.h"

namespace sinew {

/// Reads the names of the file's material variants (KHR_materials_variants).
/// warning  extension-value
std::vector<std::string> read_variants(const gltf::Document& document, IssueLog& log);

/// Reads the materials that variants give a primitive. Of two materials for one variant the first counts.
/// warning  extension-value: entries that name no variant or no material are ignored
std::vector<VariantMaterial> read_variant_materials(const gltf::Document& document, std::uint32_t mesh,
                                                    std::uint32_t primitive, IssueLog& log);

}  // namespace sinew
