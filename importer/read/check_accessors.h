// SPDX-License-Identifier: MIT
#pragma once
#include "importer/file/document.h"
#include "importer/issue_log.h"

namespace sinew {

/// Proves that every accessor can be read: elements and sparse parts lie inside their views, sparse indices inside the
/// accessor, all in 64-bit arithmetic before any pointer is formed (G24..G28, G68).
/// in   views with their bytes (load_buffers.h, decoders)
/// err  accessor-fit, accessor-stride, accessor-sparse;  warning accessor-empty, accessor-alignment, accessor-normalized,
///      accessor-sparse-order, buffer-view-stride
void check_accessors(const gltf::Document& document, IssueLog& log);

}  // namespace sinew
