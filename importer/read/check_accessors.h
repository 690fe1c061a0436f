// SPDX-License-Identifier: MIT
#pragma once
#include "importer/file/document.h"
#include "importer/issue_log.h"

namespace sinew {

/// Verifies, from the document alone, that the elements and sparse parts of every accessor lie inside their views. Uses
/// 64-bit arithmetic. It needs no buffer data, so a missing buffer does not hide other errors.
/// in       references are in range
/// err      accessor-fit, accessor-stride, accessor-sparse
/// warning  accessor-alignment, accessor-normalized, accessor-sparse-stride, buffer-view-stride
void check_accessor_layout(const gltf::Document& document, IssueLog& log);

/// Verifies that every accessor can be read: its views have the declared bytes, and sparse indices lie inside the
/// accessor.
/// in       accessors passed check_accessor_layout() or were filled by a decoder; views have their bytes
/// err      accessor-fit, accessor-stride, accessor-sparse, memory-budget
/// warning  accessor-sparse-order
void check_accessors(const gltf::Document& document, IssueLog& log);

}  // namespace sinew
