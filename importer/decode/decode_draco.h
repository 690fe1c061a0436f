// SPDX-License-Identifier: MIT
#pragma once
#include "importer/decode/decode_budget.h"
#include "importer/file/document.h"
#include "importer/issue_log.h"

namespace sinew {

/// Decodes primitives with KHR_draco_mesh_compression. Each accessor that Draco supplies gets a new buffer view with
/// decoded values in the accessor's own type. Vertices keep the decoder's order and count; compressed strips become
/// triangle lists. Must run before accessors are checked.
/// in       views have their bytes; references are in range
/// out      accessors[].buffer_view and new buffer_views; document.storage owns their bytes
/// err      json-type, json-missing, reference, decode-failed, memory-budget, at the extension of the primitive
/// warning  draco-count
/// cost     O(decoded bytes)
void decode_draco(gltf::Document& document, DecodeBudget& budget, IssueLog& log);

}  // namespace sinew
