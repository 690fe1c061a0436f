// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "importer/file/document.h"
#include "importer/issue_log.h"

namespace sinew {

/// Vertices, keys and indices that the document will grow to, before anything grows: many primitives may name one
/// accessor, and an accessor without a view costs no byte of the file (G68).
/// in   references in range;  file_bytes  with all buffers;  most  never more than this
/// err  memory-budget
void check_memory_budget(const gltf::Document& document, std::uint64_t file_bytes, std::uint64_t most, IssueLog& log);

}  // namespace sinew
