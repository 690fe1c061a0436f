// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>

namespace sinew::bench {

/// tinygltf's own parse of a .glb; answers the number of nodes, -1 on failure. Apart, since its names clash with ours.
int parse_with_tinygltf(std::span<const std::byte> glb);

}  // namespace sinew::bench
