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

/// Reads the materials of a primitive for each variant. If a variant has two, the first is used.
/// warning  extension-value: entries with an invalid variant or material are ignored
std::vector<VariantMaterial> read_variant_materials(const gltf::Document& document, std::uint32_t mesh,
                                                    std::uint32_t primitive, IssueLog& log);

}  // namespace sinew
