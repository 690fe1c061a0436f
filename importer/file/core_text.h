// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>

#include "importer/file/json_tree.h"

namespace sinew {

/// JSON text of a document's core properties, for a reader that need not be careful. Each property that gltf_shape()
/// names is in it once: the last of those with equal names, integers without a fraction, a camera with its lens. Left
/// out are extensions, extras, names of attributes that hold a zero byte, and `indices` of primitives.
/// in   root   passed check_shape(root, gltf_shape())

/// Everything outside the lists: asset, names of extensions, default scene.
std::string head_text(const JsonNode& root);

/// Some entries of a list, {"nodes":[...]}: as many as make two kilobytes.
/// in,out   next   entry to begin with; then the first one that is not in the text
std::string slice_text(const char* name, const JsonNode& list, std::size_t& next);

}  // namespace sinew
