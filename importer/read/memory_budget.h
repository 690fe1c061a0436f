// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "importer/file/document.h"
#include "importer/issue_log.h"

namespace sinew {

/// Bytes that a file may expand to: a fixed amount plus a multiple of its size (above real compression ratios), but at
/// most `most`.
std::uint64_t allowed_bytes(std::uint64_t file_bytes, std::uint64_t most) noexcept;

/// Estimates the memory of vertices, keys, indices and multiplying lists before anything is allocated. Small files can
/// expand a lot: primitives may share one accessor, and an accessor without a view has no bytes in the file.
/// in    references are in range
///       file_bytes   size of the file with all buffers
///       most         upper limit, independent of the file size
/// err   memory-budget
void check_memory_budget(const gltf::Document& document, std::uint64_t file_bytes, std::uint64_t most, IssueLog& log);

}  // namespace sinew
