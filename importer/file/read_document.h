// SPDX-License-Identifier: MIT
#pragma once
#include "importer/file/document.h"
#include "importer/file/json_tree.h"

namespace sinew {

/// Converts checked JSON (gltf_shape.h) to a Document. Buffers and images are not loaded, only their URIs are stored
/// (load_buffers.h).
/// cost  O(values)
gltf::Document read_document(const JsonNode& json);

}  // namespace sinew
