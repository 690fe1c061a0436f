// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "importer/file/document.h"
#include "importer/issue_log.h"
#include "runtime/model/material.h"

namespace sinew {

/// Every material in metallic-roughness form, with KHR_materials_unlit and KHR_materials_emissive_strength.
/// KHR_materials_pbrSpecularGlossiness is approximated unless the file brings a metallic-roughness
/// version of its own, which is then its author's choice for readers like this one.
/// in   references in range.   out  as many as document.materials, in their order
/// warning material-values, material-approximated, extension-value
std::vector<Material> read_materials(const gltf::Document& document, IssueLog& log);

}  // namespace sinew
