// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "importer/file/document.h"
#include "importer/issue_log.h"
#include "runtime/assets/mesh.h"

namespace sinew {

/// Displacements of one morph target for every vertex; an attribute that the target leaves alone is empty (G47).
struct DenseTarget {
  std::vector<glm::vec3> positions, normals, tangents;
  std::vector<glm::vec4> colors;                    ///< alpha 0 where the file has three components
  std::vector<std::vector<glm::vec2>> texcoords;
};

/// Reads one target of a primitive whose attributes have been read into `base`.
/// err  mesh-attribute-format, mesh-attribute-count, not-finite;  warning morph-no-base (attribute that the mesh lacks),
///      morph-texcoord (read, but not evaluated)
DenseTarget read_morph_target(const gltf::Document& document, std::uint32_t mesh, std::uint32_t primitive, std::uint32_t target,
                              const Primitive& base, IssueLog& log);

}  // namespace sinew
