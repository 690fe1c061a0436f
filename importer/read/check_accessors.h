// SPDX-License-Identifier: MIT
#pragma once
#include "importer/file/document.h"
#include "importer/issue_log.h"

namespace sinew {

/// Proves from the document alone that the elements and sparse parts of every accessor lie inside their views; all
/// arithmetic is in 64 bits (G25, G26, G28, G68). It needs no bytes, so a missing buffer does not hide other errors.
/// in       references in range
/// err      accessor-fit, accessor-stride, accessor-sparse
/// warning  accessor-alignment, accessor-normalized, accessor-sparse-stride, buffer-view-stride
void check_accessor_layout(const gltf::Document& document, IssueLog& log);

/// Proves that every accessor can be read: its views hold as many bytes as they promise, and sparse indices lie inside
/// the accessor (G24).
/// in       accessors that have passed check_accessor_layout or that a decoder has filled; views with their bytes
/// err      accessor-fit, accessor-stride, accessor-sparse, memory-budget
/// warning  accessor-sparse-order
void check_accessors(const gltf::Document& document, IssueLog& log);

}  // namespace sinew
