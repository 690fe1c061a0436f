// SPDX-License-Identifier: MIT
#include "tests/importer/tiny_gltf.h"

#include <algorithm>

namespace sinew::test {

std::string base64(const std::vector<std::byte>& bytes) {
  static constexpr char kAlphabet[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto at = [&](std::size_t k) { return i + k < bytes.size() ? std::to_integer<unsigned>(bytes[i + k]) : 0u; };
    const unsigned bits = at(0) << 16 | at(1) << 8 | at(2);
    for (unsigned k = 0; k < 4; ++k) text += i + k > bytes.size() ? '=' : kAlphabet[bits >> (18 - 6 * k) & 63];
  }
  return text;
}

std::size_t TinyGltf::add_accessor(std::size_t view, const char* type, int component_type, std::size_t count,
                                   bool normalized) {
  Json accessor{{"bufferView", view}, {"componentType", component_type}, {"count", count}, {"type", type}};
  if (normalized) accessor["normalized"] = true;
  root["accessors"].push_back(accessor);
  return root["accessors"].size() - 1;
}

std::size_t TinyGltf::add_bytes(std::span<const std::byte> bytes) {
  bytes_.resize((bytes_.size() + 3) / 4 * 4);
  const std::size_t offset = bytes_.size();
  bytes_.insert(bytes_.end(), bytes.begin(), bytes.end());
  root["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", offset}, {"byteLength", bytes.size()}});
  return root["bufferViews"].size() - 1;
}

std::size_t TinyGltf::times(const std::vector<float>& v) {
  const std::size_t accessor = scalars(v);
  if (!v.empty()) root["accessors"][accessor]["min"] = {*std::min_element(v.begin(), v.end())};
  if (!v.empty()) root["accessors"][accessor]["max"] = {*std::max_element(v.begin(), v.end())};
  return accessor;
}

void TinyGltf::animate(const char* path, std::size_t input, std::size_t output, const char* interpolation) {
  root["animations"] =
      Json::array({{{"samplers", {{{"input", input}, {"output", output}, {"interpolation", interpolation}}}},
                    {"channels", {{{"sampler", 0}, {"target", {{"node", 0}, {"path", path}}}}}}}});
}

Json& TinyGltf::add_triangle() {
  const std::size_t position = vec3({0, 0, 0, 1, 0, 0, 0, 1, 0});
  root["meshes"] = Json::array({{{"primitives", {{{"attributes", {{"POSITION", position}}}}}}}});
  root["nodes"] = Json::array({{{"mesh", 0}}});
  return root["meshes"][0]["primitives"][0];
}

Json& TinyGltf::add_skinned_triangle(const std::vector<std::uint8_t>& joints, const std::vector<float>& weights) {
  Json& primitive = add_triangle();
  primitive["attributes"]["JOINTS_0"] = add(joints, "VEC4", 5121, 4);
  primitive["attributes"]["WEIGHTS_0"] = vec4(weights);
  root["nodes"] = Json::array({{{"mesh", 0}, {"skin", 0}}, {{"children", {2}}}, Json::object()});
  root["skins"] = Json::array({{{"joints", {1, 2}}}});
  return root["meshes"][0]["primitives"][0];
}

std::string TinyGltf::text() const {
  Json whole = root;
  if (!bytes_.empty() && !whole.contains("buffers"))
    whole["buffers"] = Json::array(
        {{{"byteLength", bytes_.size()}, {"uri", "data:application/octet-stream;base64," + base64(bytes_)}}});
  return whole.dump();
}

ImportResult<ImportedFile> TinyGltf::import(const ImportOptions& options) const {
  const std::string json = text();
  return import_gltf(bytes_of(json), "tiny.gltf", options);
}

std::string outcome(const ImportResult<ImportedFile>& result) {
  return result ? "ok" : result.error().issue.rule + " at " + result.error().issue.json_pointer;
}

std::string survived(const ImportResult<ImportedFile>& result) {
  if (!result) return outcome(result);
  std::string text;
  for (const ImportIssue& issue : result->warnings)
    if (issue.severity == Severity::error)
      text += (text.empty() ? "" : ", ") + issue.rule + " at " + issue.json_pointer;
  return text;
}

bool warns(const ImportResult<ImportedFile>& result, const std::string& rule, const std::string& json_pointer) {
  if (!result) return false;
  return std::any_of(result->warnings.begin(), result->warnings.end(), [&](const ImportIssue& issue) {
    return issue.rule == rule && issue.json_pointer == json_pointer && issue.severity == Severity::warning;
  });
}

}  // namespace sinew::test
