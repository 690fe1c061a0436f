// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <filesystem>
#include <span>

namespace sinew::bench {

/// Parses a .glb with tinygltf: JSON and a copy of the buffers, without decoding images. Returns the number of nodes,
/// -1 on failure. It has a file of its own, because tinygltf's names clash with ours.
int parse_with_tinygltf(std::span<const std::byte> glb);

/// Same, for a .gltf or .glb file with its buffers.
int parse_with_tinygltf(const std::filesystem::path& file);

}  // namespace sinew::bench
