// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "importer/import_error.h"

namespace sinew {

/// Positions and faces of an OBJ file; polygons are cut into fans. Point caches belong to such meshes.
struct ObjMesh {
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> triangles;
};

/// Reads the lines `v` and `f` and passes over all others.
/// err  obj-syntax  a line that is cut off or has no numbers where they belong
///      obj-index   a face names a vertex that is not there
///      obj-values  a position that is not finite
///      obj-empty   no vertex
/// cost O(text)
ImportResult<ObjMesh> read_obj(std::string_view text, const std::string& name);

}  // namespace sinew
