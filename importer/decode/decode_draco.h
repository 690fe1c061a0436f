// SPDX-License-Identifier: MIT
#pragma once
#include "importer/decode/decode_budget.h"
#include "importer/file/document.h"
#include "importer/issue_log.h"

namespace sinew {

/// Decodes the primitives that KHR_draco_mesh_compression describes, before anybody looks at their accessors: each
/// accessor that Draco supplies gets a view of its own with the decoded values in the accessor's type (G62). Vertices
/// stay in the decoder's order. in   views with their bytes, references in range out  accessors[].buffer_view, new
/// buffer_views, owned by document.storage; compressed strips become triangle lists err  json-type, json-missing,
/// reference, decode-failed, memory-budget with a pointer at the primitive's extension cost O(decoded bytes)
void decode_draco(gltf::Document& document, DecodeBudget& budget, IssueLog& log);

}  // namespace sinew
