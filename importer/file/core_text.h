// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>

#include "importer/file/json_tree.h"

namespace sinew {

/// Writes normalised JSON text of a document's core properties, for tinygltf. Each property of gltf_shape() occurs once
/// (of duplicates, the last), integers have no fraction, and cameras have a lens object. Omits extensions, extras,
/// attribute names with a zero byte, and `indices` of primitives.
/// in   root   passed check_shape(root, gltf_shape())

/// Text of everything outside the lists: asset, extension names, default scene.
std::string head_text(const JsonNode& root);

/// Text of some entries of a list, such as {"nodes":[...]}: about two kilobytes.
/// in,out   next   first entry to write; then the first one not written
std::string slice_text(const char* name, const JsonNode& list, std::size_t& next);

}  // namespace sinew
