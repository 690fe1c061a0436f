// SPDX-License-Identifier: MIT
#pragma once
#include "importer/file/document.h"
#include "importer/issue_log.h"

namespace sinew {

/// Proves, by what the document says alone, that the elements and sparse parts of every accessor lie inside their
/// views, all in 64-bit arithmetic (G25, G26, G28, G68). It needs no bytes, so that a missing buffer hides nothing. in
/// references in range err  accessor-fit, accessor-stride, accessor-sparse;  warning accessor-alignment,
/// accessor-normalized,
///      accessor-sparse-stride, buffer-view-stride
void check_accessor_layout(const gltf::Document& document, IssueLog& log);

/// Proves that every accessor can be read: its views have the bytes that they promise, and sparse indices lie inside
/// the accessor (G24). in   accessors that passed check_accessor_layout, or have been filled by a decoder; views with
/// their bytes err  accessor-fit, accessor-stride, accessor-sparse, memory-budget;  warning accessor-sparse-order
void check_accessors(const gltf::Document& document, IssueLog& log);

}  // namespace sinew
