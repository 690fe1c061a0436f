// SPDX-License-Identifier: MIT
#pragma once
#include "importer/decode/decode_budget.h"
#include "importer/file/document.h"
#include "importer/issue_log.h"

namespace sinew {

/// Fills the views that EXT_meshopt_compression or KHR_meshopt_compression describes: attribute streams of versions 0
/// and 1, triangle and index streams, and all filters. What the fallback buffer holds is ignored, unless a later
/// version made the stream (G61).
/// in       buffers with their bytes
/// out      document.buffer_views[].bytes, owned by document.storage
/// err      json-type, json-missing, reference, buffer-view-range, decode-failed, meshopt-version, memory-budget, at
///          the extension of the view
/// warning  meshopt-fallback
/// cost     O(decoded bytes)
void decode_meshopt(gltf::Document& document, DecodeBudget& budget, IssueLog& log);

}  // namespace sinew
