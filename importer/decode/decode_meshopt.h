// SPDX-License-Identifier: MIT
#pragma once
#include "importer/decode/decode_budget.h"
#include "importer/file/document.h"
#include "importer/issue_log.h"

namespace sinew {

/// Decodes views with EXT_meshopt_compression or KHR_meshopt_compression: attribute streams of versions 0 and 1,
/// triangle and index streams, and all filters. The fallback buffer is used only if the stream has a later version.
/// in       buffers have their bytes
/// out      document.buffer_views[].bytes, owned by document.storage
/// err      json-type, json-missing, reference, buffer-view-range, decode-failed, meshopt-version, memory-budget, at
///          the extension of the view
/// warning  meshopt-fallback
/// cost     O(decoded bytes)
void decode_meshopt(gltf::Document& document, DecodeBudget& budget, IssueLog& log);

}  // namespace sinew
