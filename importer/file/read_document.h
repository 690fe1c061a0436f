// SPDX-License-Identifier: MIT
#pragma once
#include "importer/file/document.h"
#include "importer/file/json_tree.h"

namespace sinew {

/// A document whose shape has been checked (gltf_shape.h), as plain data. Nothing is read but the JSON:
/// buffers and images keep their URIs (load_buffers.h).
/// cost O(values)
gltf::Document read_document(const JsonNode& json);

}  // namespace sinew
