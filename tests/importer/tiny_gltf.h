// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstring>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "importer/import_gltf.h"

namespace sinew::test {

using Json = nlohmann::json;

inline std::span<const std::byte> bytes_of(const std::string& text) { return std::as_bytes(std::span(text)); }

inline std::string base64(const std::vector<std::byte>& bytes) {
  static constexpr char kAlphabet[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto at = [&](std::size_t k) { return i + k < bytes.size() ? std::to_integer<unsigned>(bytes[i + k]) : 0u; };
    const unsigned bits = at(0) << 16 | at(1) << 8 | at(2);
    for (unsigned k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : kAlphabet[bits >> (18 - 6 * k) & 63];
  }
  return text;
}

/// Builds a document: JSON that tests may change at will, and one buffer that becomes a data URI.
class TinyGltf {
 public:
  Json root{{"asset", {{"version", "2.0"}}}};

  /// Appends values as a new view with an accessor; returns the accessor's index.
  template <class T>
  std::size_t add(const std::vector<T>& values, const char* type, int component_type, std::size_t components,
                  bool normalized = false) {
    const std::size_t view = add_view(values);
    Json accessor{
        {"bufferView", view}, {"componentType", component_type}, {"count", values.size() / components}, {"type", type}};
    if (normalized) accessor["normalized"] = true;
    root["accessors"].push_back(accessor);
    return root["accessors"].size() - 1;
  }

  template <class T>
  std::size_t add_view(const std::vector<T>& values) {
    bytes_.resize((bytes_.size() + 3) / 4 * 4);
    const std::size_t offset = bytes_.size(), size = values.size() * sizeof(T);
    bytes_.resize(offset + size);
    if (size > 0) std::memcpy(bytes_.data() + offset, values.data(), size);
    root["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", offset}, {"byteLength", size}});
    return root["bufferViews"].size() - 1;
  }

  std::size_t scalars(const std::vector<float>& v) { return add(v, "SCALAR", 5126, 1); }
  std::size_t vec3(const std::vector<float>& v) { return add(v, "VEC3", 5126, 3); }
  std::size_t vec4(const std::vector<float>& v) { return add(v, "VEC4", 5126, 4); }

  /// Key times with min and max, which glTF demands.
  std::size_t times(const std::vector<float>& v) {
    const std::size_t accessor = scalars(v);
    if (!v.empty()) root["accessors"][accessor]["min"] = {*std::min_element(v.begin(), v.end())};
    if (!v.empty()) root["accessors"][accessor]["max"] = {*std::max_element(v.begin(), v.end())};
    return accessor;
  }

  /// One animation of one channel on node 0.
  void animate(const char* path, std::size_t input, std::size_t output, const char* interpolation = "LINEAR") {
    root["animations"] =
        Json::array({{{"samplers", {{{"input", input}, {"output", output}, {"interpolation", interpolation}}}},
                      {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", path}}}}}}}});
  }

  /// Node 0 with a mesh of one triangle.
  Json& add_triangle() {
    const std::size_t position = vec3({0, 0, 0, 1, 0, 0, 0, 1, 0});
    root["meshes"] = Json::array({{{"primitives", {{{"attributes", {{"POSITION", position}}}}}}}});
    root["nodes"] = Json::array({{{"mesh", 0}}});
    return root["meshes"][0]["primitives"][0];
  }

  /// The triangle moved by a skin of two joints (nodes 1 and 2); `joints` and `weights` have four entries a vertex.
  Json& add_skinned_triangle(const std::vector<std::uint8_t>& joints, const std::vector<float>& weights) {
    Json& primitive = add_triangle();
    primitive["attributes"]["JOINTS_0"] = add(joints, "VEC4", 5121, 4);
    primitive["attributes"]["WEIGHTS_0"] = vec4(weights);
    root["nodes"] = Json::array({{{"mesh", 0}, {"skin", 0}}, {{"children", {2}}}, Json::object()});
    root["skins"] = Json::array({{{"joints", {1, 2}}}});
    return root["meshes"][0]["primitives"][0];
  }

  std::string text() const {
    Json whole = root;
    if (!bytes_.empty() && !whole.contains("buffers"))
      whole["buffers"] = Json::array(
          {{{"byteLength", bytes_.size()}, {"uri", "data:application/octet-stream;base64," + base64(bytes_)}}});
    return whole.dump();
  }

  ImportResult<ImportedFile> import(const ImportOptions& options = {}) const {
    const std::string json = text();
    return import_gltf(bytes_of(json), "tiny.gltf", options);
  }

 private:
  std::vector<std::byte> bytes_;
};

/// "rule at /pointer" of an error, or "ok".
inline std::string outcome(const ImportResult<ImportedFile>& result) {
  return result ? "ok" : result.error().issue.rule + " at " + result.error().issue.json_pointer;
}

/// True when the import succeeded with this warning at this place.
inline bool warns(const ImportResult<ImportedFile>& result, const std::string& rule, const std::string& json_pointer) {
  if (!result) return false;
  return std::any_of(result->warnings.begin(), result->warnings.end(), [&](const ImportIssue& issue) {
    return issue.rule == rule && issue.json_pointer == json_pointer && issue.severity == Severity::warning;
  });
}

}  // namespace sinew::test
