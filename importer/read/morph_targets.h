// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "importer/file/document.h"
#include "importer/issue_log.h"
#include "importer/read/accessor.h"
#include "runtime/model/mesh.h"

namespace sinew {

/// Displacements of one attribute in the file's order. A sparse accessor names the vertices that it moves in any order;
/// of several values for one vertex the last counts. Otherwise `indices` is empty, and there is one value for each
/// vertex or no value at all.
template <class V>
using Displacements = Replacements<V>;

/// One morph target. An attribute that the target does not displace is empty (G47).
struct TargetData {
  Displacements<glm::vec3> positions, normals, tangents;
  Displacements<glm::vec4> colors;  ///< alpha is 0 where the file has three components
  std::vector<Displacements<glm::vec2>> texcoords;
};

/// Reads one target of a primitive whose own attributes have been read into `base`.
/// err      mesh-attribute-format, mesh-attribute-count, not-finite
/// warning  mesh-attribute-name, morph-no-base (the mesh lacks the attribute), morph-texcoord (read, but not evaluated)
TargetData read_morph_target(const gltf::Document& document, std::uint32_t mesh, std::uint32_t primitive,
                             std::uint32_t target, const Primitive& base, IssueLog& log);

}  // namespace sinew
