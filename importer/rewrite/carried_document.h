// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <vector>

#include "importer/file/document.h"

namespace sinew {

/// A parsed file, kept next to its imported scene: the complete JSON and all bytes that it refers to. Repairs of the
/// import do not change it.
struct CarriedDocument {
  gltf::Json json;
  gltf::Document document;      ///< buffers and images are loaded, compressed data is decoded
  std::vector<std::byte> file;  ///< the file itself; `document` points into it
};

}  // namespace sinew
