// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>

#include "importer/file/document_materials.h"
#include "importer/issue_log.h"
#include "runtime/model/material.h"

namespace sinew {

/// Reads the material layers of extensions: KHR_materials_ior, KHR_materials_specular, KHR_materials_clearcoat,
/// KHR_materials_sheen and KHR_materials_transmission.
/// in       place  JSON pointer of the material;   extensions  of the material
/// out      the members specular, clearcoat, sheen and transmission of the material
/// warning  extension-value
void read_material_layers(const gltf::Json& extensions, const std::string& place, std::size_t texture_count,
                          Material& material, IssueLog& log);

}  // namespace sinew
