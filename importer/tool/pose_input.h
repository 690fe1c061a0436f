// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include <tl/expected.hpp>

#include "importer/import_error.h"
#include "importer/tool/pose.h"

namespace sinew::tool {

/// Reads a pose file, .json or .json.gz, told apart by content. Unknown keys are skipped.
/// err   rules "pose-file" (missing, unreadable, not JSON) and "pose-format" (with the JSON pointer of the wrong value)
/// cost  O(file); a compressed file may unpack to at most 256 times its size
tl::expected<PoseFile, ImportIssue> read_poses(const std::string& file);

/// The same from text.
tl::expected<PoseFile, ImportIssue> parse_poses(const std::string& text);

}  // namespace sinew::tool
