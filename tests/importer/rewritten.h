// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include "importer/rewrite_gltf.h"
#include "tests/importer/tiny_gltf.h"

/// Helpers for tests of rewrite_gltf(): one call from document to document, and the parts of a .glb.
namespace sinew::test {

inline ImportOptions carrying() {
  ImportOptions options;
  options.carry_document = true;
  options.decode_images = false;
  return options;
}

struct GlbParts {
  Json json;
  std::vector<std::byte> bin;

  /// The bytes of a buffer view.
  std::vector<std::byte> view(std::size_t index) const {
    const Json& v = json["bufferViews"][index];
    const auto begin = bin.begin() + v.value("byteOffset", 0);
    return {begin, begin + v["byteLength"].get<std::ptrdiff_t>()};
  }
};

inline GlbParts split_glb(const std::vector<std::byte>& glb) {
  const auto u32 = [&](std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, glb.data() + at, 4);
    return std::size_t{value};
  };
  const std::size_t length = u32(12);
  const auto* text = reinterpret_cast<const char*>(glb.data()) + 20;
  GlbParts parts{Json::parse(text, text + length), {}};
  if (glb.size() > 28 + length) parts.bin.assign(glb.begin() + 28 + static_cast<std::ptrdiff_t>(length), glb.end());
  return parts;
}

/// The result of importing and rewriting, or the error of either.
inline ImportResult<RewrittenFile> rewrite(const TinyGltf& gltf, const RewriteOptions& options = {}) {
  const auto file = gltf.import(carrying());
  if (!file) return tl::unexpected(file.error());
  return rewrite_gltf(*file, options);
}

inline GlbParts rewritten(const TinyGltf& gltf, const RewriteOptions& options = {}) {
  const auto out = rewrite(gltf, options);
  if (!out) throw std::runtime_error(describe("rewritten", out.error().issue));
  return split_glb(out->file);
}

/// The document without the properties that say where bytes lie: buffers, buffer views and references to them.
inline Json without_places(Json root) {
  for (const char* list : {"buffers", "bufferViews"}) root.erase(list);
  return root;
}

}  // namespace sinew::test
