// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "importer/file/document.h"
#include "importer/issue_log.h"

namespace sinew {

/// How many bytes a file may unpack or grow to: a fixed amount and a multiple of its size that good compression does
/// not reach, but never more than `most` (G68).
std::uint64_t allowed_bytes(std::uint64_t file_bytes, std::uint64_t most) noexcept;

/// Adds up how many bytes the document will grow to as vertices, keys and indices, and by lists that multiply with each
/// other, before anything grows. Many primitives may share one accessor, and an accessor without a view costs no bytes
/// in the file (G68).
/// in    references in range
///       file_bytes   with all buffers
///       most         upper limit, whatever the size of the file
/// err   memory-budget
void check_memory_budget(const gltf::Document& document, std::uint64_t file_bytes, std::uint64_t most, IssueLog& log);

}  // namespace sinew
