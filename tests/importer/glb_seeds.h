// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace sinew::test {

/// Makes a .glb from JSON text and a binary chunk, with padding.
std::vector<std::byte> make_glb(std::string json, std::vector<std::byte> bin);

/// Small valid files that together touch every part of the importer: skin, morph targets, sparse accessors, animations
/// in all modes, materials, an embedded image, cameras, lights, both compressions.
std::vector<std::vector<std::byte>> glb_seeds();

}  // namespace sinew::test
