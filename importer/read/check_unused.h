// SPDX-License-Identifier: MIT
#pragma once
#include "importer/file/document.h"
#include "importer/issue_log.h"

namespace sinew {

/// Checks accessors that the import does not read. They do not affect poses, but violations are still reported.
/// in       accessors fit their views
/// warning  not-finite
/// cost     O(elements), bounded
void check_unused_accessors(const gltf::Document& document, IssueLog& log);

/// Checks samplers of animations that no channel uses. Without a channel there is no target, so only key times and the
/// number and values of the keys are checked.
/// in       accessors fit their views
/// warning  animation-input, animation-output, animation-times, animation-values, animation-no-keys
/// cost     O(elements), bounded
void check_unused_samplers(const gltf::Document& document, IssueLog& log);

/// Checks that positions have min and max, which programs use as bounds of a mesh.
/// warning  mesh-position-bounds
void check_position_bounds(const gltf::Document& document, IssueLog& log);

}  // namespace sinew
