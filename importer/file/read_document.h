// SPDX-License-Identifier: MIT
#pragma once
#include "importer/file/document.h"
#include "importer/file/json_tree.h"

namespace sinew {

/// Turns the JSON of a document, whose shape has been checked (gltf_shape.h), into plain data. It reads only the JSON:
/// buffers and images keep their URIs (load_buffers.h).
/// cost  O(values)
gltf::Document read_document(const JsonNode& json);

}  // namespace sinew
