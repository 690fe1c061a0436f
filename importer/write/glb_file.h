// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "importer/file/tinygltf.h"

namespace sinew::write {

/// The bytes of a .glb. Buffer 0 becomes the BIN chunk and is moved out of the model.
/// eq    12 bytes header (magic, version, length), JSON chunk padded with spaces, BIN chunk padded with zeros (glTF
///       2.0, "Binary glTF Layout")
/// out   empty if the file would have 4 GiB or more: its lengths have 32 bits
std::optional<std::vector<std::byte>> glb_file(tinygltf::Model& model);

}  // namespace sinew::write
