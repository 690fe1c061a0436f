// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "importer/file/json_tree.h"

namespace sinew {

/// Memory in bytes of the gltf::Document entries of tinygltf's types, without their strings and arrays. It is computed
/// before reading, because a material of two characters ("{}") takes two thousand bytes.
/// in    root   passed check_shape(root, gltf_shape())
/// cost  O(meshes)
std::uint64_t entry_bytes(const JsonNode& root) noexcept;

}  // namespace sinew
