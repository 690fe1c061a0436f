// SPDX-License-Identifier: MIT
#pragma once
#include "importer/decode/decode_budget.h"
#include "importer/file/document.h"
#include "importer/issue_log.h"

namespace sinew {

/// Decodes the primitives that KHR_draco_mesh_compression describes. Each accessor that Draco supplies gets a new view
/// with the decoded values in the accessor's own type (G62). Vertices stay in the decoder's order and number;
/// compressed strips become triangle lists. It must run before accessors are checked.
/// in       views with their bytes, references in range
/// out      accessors[].buffer_view and new buffer_views, whose bytes document.storage owns
/// err      json-type, json-missing, reference, decode-failed, memory-budget, at the extension of the primitive
/// warning  draco-count
/// cost     O(decoded bytes)
void decode_draco(gltf::Document& document, DecodeBudget& budget, IssueLog& log);

}  // namespace sinew
