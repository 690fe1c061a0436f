// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <filesystem>
#include <span>

namespace sinew::bench {

/// tinygltf's own parse of a .glb: JSON, and a copy of the buffers; images stay as they are. Answers the number of
/// nodes, -1 on failure. Apart, since its names clash with ours.
int parse_with_tinygltf(std::span<const std::byte> glb);

/// The same of a .gltf or .glb file with its buffers.
int parse_with_tinygltf(const std::filesystem::path& file);

}  // namespace sinew::bench
