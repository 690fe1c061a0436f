// SPDX-License-Identifier: MIT
#pragma once
#include <optional>

#include "importer/file/document.h"
#include "importer/issue_log.h"

namespace sinew {

/// A document whose shape has been checked (gltf_shape.h), as plain data. Nothing is read but the JSON, and parts of it are moved
/// into the answer: buffers and images keep their URIs (load_buffers.h).
/// err  json-syntax with the parser's words
std::optional<gltf::Document> read_document(gltf::Json json, IssueLog& log);

}  // namespace sinew
