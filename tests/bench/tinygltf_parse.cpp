// SPDX-License-Identifier: MIT
#include "tests/bench/tinygltf_parse.h"

#include "importer/file/tinygltf.h"

namespace sinew::bench {

int parse_with_tinygltf(std::span<const std::byte> glb) {
  tinygltf::Model model;
  tinygltf::TinyGLTF loader;
  std::string error, warning;
  const bool ok = loader.LoadBinaryFromMemory(&model, &error, &warning, reinterpret_cast<const unsigned char*>(glb.data()),
                                              static_cast<unsigned int>(glb.size()));
  return ok ? static_cast<int>(model.nodes.size()) : -1;
}

}  // namespace sinew::bench
