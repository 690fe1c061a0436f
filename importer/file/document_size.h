// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "importer/file/json_tree.h"

namespace sinew {

/// How many bytes the entries of gltf::Document take that tinygltf reads, without what their texts and numbers add. A
/// material of two characters ("{}") takes two thousand bytes there, so this is known before any is made.
/// in    root   passed check_shape(root, gltf_shape())
/// cost  O(meshes)
std::uint64_t entry_bytes(const JsonNode& root) noexcept;

}  // namespace sinew
