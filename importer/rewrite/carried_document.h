// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <vector>

#include "importer/file/document.h"

namespace sinew {

/// A whole file beside the scene that was made from it: every name and value of its JSON, and all bytes that it refers
/// to. Nothing in it is changed by the repairs of the import.
struct CarriedDocument {
  gltf::Json json;
  gltf::Document document;      ///< buffers and images are loaded, compressed data is decoded
  std::vector<std::byte> file;  ///< the file itself; `document` points into it
};

}  // namespace sinew
