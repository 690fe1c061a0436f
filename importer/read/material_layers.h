// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>

#include "importer/file/document_materials.h"
#include "importer/issue_log.h"
#include "runtime/model/material.h"

namespace sinew {

/// Reads the material layers of extensions: KHR_materials_ior, KHR_materials_specular, KHR_materials_clearcoat,
/// KHR_materials_sheen, KHR_materials_transmission, KHR_materials_iridescence, KHR_materials_anisotropy and
/// KHR_materials_volume.
/// in       place  JSON pointer of the material;   extensions  of the material
/// out      the members of the material that these extensions set
/// warning  extension-value
void read_material_layers(const gltf::Json& extensions, const std::string& place, std::size_t texture_count,
                          Material& material, IssueLog& log);

}  // namespace sinew
