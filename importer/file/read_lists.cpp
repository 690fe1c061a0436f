// SPDX-License-Identifier: MIT
#include "importer/file/read_lists.h"

#include <stdexcept>
#include <string>

#include "importer/file/core_text.h"

namespace sinew {
namespace {

tinygltf::Model load(const std::string& text) {
  tinygltf::TinyGLTF reader;
  tinygltf::Model out;
  std::string error, warning;
  if (!reader.LoadASCIIFromString(&out, &error, &warning, text.data(), static_cast<unsigned>(text.size()), "",
                                  tinygltf::NO_REQUIRE))
    throw std::runtime_error("tinygltf: " + error);
  return out;
}

}  // namespace

tinygltf::Model read_head(const JsonNode& root) { return load(head_text(root)); }

tinygltf::Model read_slice(const char* name, const JsonNode& list, std::size_t& next) {
  return load(slice_text(name, list, next));
}

void expect_all(const char* name, std::size_t expected, std::size_t read) {
  if (expected != read)
    throw std::runtime_error("tinygltf: " + std::to_string(read) + " " + name + " of " + std::to_string(expected));
}

}  // namespace sinew
