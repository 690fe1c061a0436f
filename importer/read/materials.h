// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "importer/file/document.h"
#include "importer/issue_log.h"
#include "runtime/model/material.h"

namespace sinew {

/// Reads every material in metallic-roughness form, with KHR_materials_unlit, KHR_materials_emissive_strength and the
/// extensions of material_layers.h. KHR_materials_pbrSpecularGlossiness becomes a dielectric with a specular colour,
/// unless the material also has metallic-roughness values, which are its intended fallback.
/// in       references are in range
/// out      one entry for each of document.materials, in their order
/// warning  material-values, extension-value; material-extension, once for each unsupported extension
std::vector<Material> read_materials(const gltf::Document& document, IssueLog& log);

}  // namespace sinew
