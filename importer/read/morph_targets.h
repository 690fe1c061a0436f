// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "importer/file/document.h"
#include "importer/issue_log.h"
#include "importer/read/accessor.h"
#include "runtime/model/mesh.h"

namespace sinew {

/// Displacements of one attribute, in file order. From a sparse accessor: `indices` are the moved vertices in any
/// order; of duplicates, the last counts. Otherwise `indices` is empty, and there is one value per vertex or none.
template <class V>
using Displacements = Replacements<V>;

/// One morph target. Attributes that it does not displace are empty.
struct TargetData {
  Displacements<glm::vec3> positions, normals, tangents;
  Displacements<glm::vec4> colors;  ///< alpha is 0 if the file has three components
  std::vector<Displacements<glm::vec2>> texcoords;
};

/// Reads one target of a primitive whose own attributes have been read into `base`.
/// err      mesh-attribute-format, mesh-attribute-count, not-finite
/// warning  mesh-attribute-name, morph-no-base (the mesh lacks the attribute), morph-texcoord (read, but not evaluated)
TargetData read_morph_target(const gltf::Document& document, std::uint32_t mesh, std::uint32_t primitive,
                             std::uint32_t target, const Primitive& base, IssueLog& log);

}  // namespace sinew
