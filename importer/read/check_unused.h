// SPDX-License-Identifier: MIT
#pragma once
#include "importer/file/document.h"
#include "importer/issue_log.h"

namespace sinew {

/// Looks into accessors that nothing of the import reads. They cannot harm a pose, but the file is broken.
/// in       accessors that fit their views
/// warning  not-finite
/// cost     O(elements), bounded
void check_unused_accessors(const gltf::Document& document, IssueLog& log);

/// Positions have min and max, which programs use as the bounds of a mesh.
/// warning  mesh-position-bounds
void check_position_bounds(const gltf::Document& document, IssueLog& log);

}  // namespace sinew
