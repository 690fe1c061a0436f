// SPDX-License-Identifier: MIT
#pragma once
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "tests/importer/rewritten.h"

/// Helpers for tests of quantized and compressed files.
namespace sinew::test {

inline RewriteOptions how(bool quantize, bool meshopt) {
  RewriteOptions options;
  options.quantize = options.merge_vertices = quantize;
  options.meshopt = meshopt;
  return options;
}

struct Both {
  ImportedFile before, after;
  GlbParts parts;
  std::size_t bytes = 0;
};

inline Both recoded(const TinyGltf& gltf, const RewriteOptions& options) {
  auto before = gltf.import(carrying());
  if (!before) throw std::runtime_error(before.error().issue.detail);
  const auto out = rewrite_gltf(*before, options);
  if (!out) throw std::runtime_error(out.error().issue.detail);
  auto after = import_gltf(out->file, "recoded.glb");
  if (!after) throw std::runtime_error(describe("recoded.glb", after.error().issue));
  return {*std::move(before), *std::move(after), split_glb(out->file), out->file.size()};
}

inline const Primitive& first(const ImportedFile& file) { return file.scene.meshes[0].primitives[0]; }

/// A rewritten stream: component type, normalised or not, bounds or not, and filter.
inline std::string stored_as(const Json& json, const Json& accessor_index) {
  const Json& accessor = json["accessors"][accessor_index.get<std::size_t>()];
  const Json& view = json["bufferViews"][accessor["bufferView"].get<std::size_t>()];
  std::string out = std::to_string(accessor["componentType"].get<int>());
  if (accessor.value("normalized", false)) out += " normalized";
  if (accessor.contains("min") && accessor.contains("max")) out += " bounds";
  if (view.contains("extensions"))
    out += " " + view["extensions"]["EXT_meshopt_compression"].value("filter", std::string("NONE"));
  return out;
}

/// The bytes of the accessor of one attribute of the first primitive.
inline std::vector<std::byte> bytes_of(const GlbParts& parts, const char* attribute) {
  const Json& accessor =
      parts.json["accessors"][parts.json["meshes"][0]["primitives"][0]["attributes"][attribute].get<std::size_t>()];
  std::vector<std::byte> view = parts.view(accessor["bufferView"].get<std::size_t>());
  view.erase(view.begin(), view.begin() + accessor.value("byteOffset", 0));
  return view;
}

}  // namespace sinew::test
