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
  std::uint32_t set = 0;  ///< the number behind TEXCOORD_, COLOR_, JOINTS_, WEIGHTS_
};

/// Parses "TEXCOORD_1" and the like; nothing for application-specific or unknown names.
std::optional<Semantic> parse_semantic(std::string_view name);

/// Checks the type and component type of a vertex attribute, or of its displacement in a morph target, against the
/// tables of glTF 2.0 ("Meshes") and KHR_mesh_quantization (G17, G37, G59).
/// err      mesh-attribute-format
/// warning  mesh-quantization (integers without the extension declared)
bool check_vertex_format(const gltf::Document& document, std::uint32_t accessor, Attribute attribute, bool displacement,
                         const std::string& place, IssueLog& log);

}  // namespace sinew
