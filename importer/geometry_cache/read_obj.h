// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "importer/import_error.h"

namespace sinew {

/// Positions and triangles of an OBJ file; polygons are split into fans. Point caches usually come with such a mesh.
struct ObjMesh {
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> triangles;
};

/// Reads the lines `v` and `f`; ignores all others.
/// err  obj-syntax  an incomplete line, or one with invalid numbers
///      obj-index   a face with an invalid vertex index
///      obj-values  a position that is not finite
///      obj-empty   no vertex
/// cost O(text)
ImportResult<ObjMesh> read_obj(std::string_view text, const std::string& name);

}  // namespace sinew
