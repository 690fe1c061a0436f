// SPDX-License-Identifier: MIT
#pragma once
#include "importer/decode/decode_budget.h"
#include "importer/file/document.h"
#include "importer/issue_log.h"

namespace sinew {

/// Fills the views that EXT_meshopt_compression (KHR_meshopt_compression) describes: vertex, triangle and index streams
/// of version 0, octahedral, quaternion and exponential filters. What a fallback buffer holds is not looked at (G61).
/// in   buffers with their bytes
/// out  document.buffer_views[].bytes, owned by document.storage
/// err  json-type, json-missing, reference, buffer-view-range, decode-failed with a pointer at the view's extension
/// cost O(decoded bytes)
void decode_meshopt(gltf::Document& document, DecodeBudget& budget, IssueLog& log);

}  // namespace sinew
