// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "importer/file/document.h"
#include "importer/issue_log.h"

namespace sinew {

enum class Attribute : std::uint8_t { position, normal, tangent, texcoord, color, joints, weights };

struct Semantic {
  Attribute attribute = Attribute::position;
  std::uint32_t set = 0;  ///< the number after TEXCOORD_, COLOR_, JOINTS_, WEIGHTS_
};

/// Parses an attribute name such as "TEXCOORD_1"; empty for application-specific or unknown names.
std::optional<Semantic> parse_semantic(std::string_view name);

/// Checks the type and component type of a vertex attribute or a morph displacement against the tables of glTF 2.0
/// ("Meshes") and KHR_mesh_quantization.
/// err      mesh-attribute-format
/// warning  mesh-quantization (integer data, but the extension is not declared)
bool check_vertex_format(const gltf::Document& document, std::uint32_t accessor, Attribute attribute, bool displacement,
                         const std::string& place, IssueLog& log);

}  // namespace sinew
