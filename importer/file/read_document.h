// SPDX-License-Identifier: MIT
#pragma once
#include "importer/file/document.h"
#include "importer/file/json_tree.h"

namespace sinew {

/// Turns the JSON of a document, whose shape has been checked (gltf_shape.h), into plain data. Most entries are read by
/// tinygltf from their core properties (read_lists.h), and the rest is taken from the tree. Only the JSON is read:
/// buffers and images keep their URIs (load_buffers.h).
/// cost  O(values)
gltf::Document read_document(const JsonNode& json);

}  // namespace sinew
