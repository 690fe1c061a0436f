// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <filesystem>
#include <span>

namespace sinew::bench {

/// Parses a .glb with tinygltf: JSON and a copy of the buffers, images not decoded. Returns the number of nodes, -1 on
/// failure. A file of its own, since tinygltf's names clash with ours.
int parse_with_tinygltf(std::span<const std::byte> glb);

/// The same for a .gltf or .glb file with its buffers.
int parse_with_tinygltf(const std::filesystem::path& file);

}  // namespace sinew::bench
