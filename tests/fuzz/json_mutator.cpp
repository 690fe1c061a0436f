// SPDX-License-Identifier: MIT
#include "tests/fuzz/json_mutator.h"

#include <array>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/support/fixed_random.h"

namespace sinew::fuzz {
namespace {

using Json = nlohmann::json;

constexpr std::size_t kMostValues = 4096, kDeepest = 64;

/// All values of the document, parents before children.
void list_values(Json& value, std::size_t depth, std::vector<Json*>& out) {
  if (out.size() >= kMostValues || depth > kDeepest) return;
  out.push_back(&value);
  if (value.is_structured())
    for (Json& entry : value) list_values(entry, depth + 1, out);
}

Json odd_value(test::FixedRandom& random) {
  static const std::array<Json, 22> kOdd{0,
                                         1,
                                         -1,
                                         2,
                                         3,
                                         4,
                                         7,
                                         15,
                                         16,
                                         255,
                                         256,
                                         65535,
                                         65536,
                                         2147483647,
                                         4294967295,
                                         9007199254740993,
                                         1e30,
                                         0.5,
                                         -0.0,
                                         nullptr,
                                         Json::array(),
                                         Json::object()};
  return kOdd[random.below(static_cast<std::uint32_t>(kOdd.size()))];
}

void change_number(Json& value, test::FixedRandom& random) {
  if (random.below(3) == 0)
    value = odd_value(random);
  else if (value.is_number_integer())
    value = value.get<std::int64_t>() / 2 + static_cast<std::int64_t>(random.below(9)) - 4;
  else
    value = value.get<double>() * random.in(-2, 2);
}

void change_string(Json& value, const MutateBytes& mutate_bytes) {
  std::string text = value.get<std::string>();
  const std::size_t size = text.size();
  text.resize(size + 16);
  text.resize(mutate_bytes(reinterpret_cast<std::uint8_t*>(text.data()), size, text.size()));
  value = std::move(text);
}

void change_array(Json& value, test::FixedRandom& random) {
  if (value.empty()) return value.push_back(odd_value(random));
  const auto at = [&] { return value.begin() + random.below(static_cast<std::uint32_t>(value.size())); };
  switch (random.below(3)) {
    case 0: value.erase(at()); break;
    case 1: value.push_back(Json(*at())); break;
    default: std::swap(*at(), *at()); break;
  }
}

/// Members that glTF and its extensions define, each with a value of the right type. Small indices are valid in most
/// files, so that the importer reads the new member instead of refusing it.
const std::vector<std::pair<std::string, Json>>& known_members() {
  static const std::vector<std::pair<std::string, Json>> known = [] {
    constexpr const char* kMembers = R"({"mesh": 0, "skin": 0, "camera": 0, "children": [1], "weights": [0.5],
      "matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0, 1,2,3,1], "rotation": [0,0,0,1], "scale": [1,2,1], "translation": [1,0,0],
      "byteStride": 12, "byteOffset": 4, "target": 34963, "normalized": true, "min": [0], "max": [1], "count": 3,
      "sparse": {"count": 1, "indices": {"bufferView": 0, "componentType": 5121}, "values": {"bufferView": 0}},
      "componentType": 5123, "type": "VEC4", "mode": 5, "indices": 0, "material": 0, "targets": [{"POSITION": 0}],
      "attributes": {"POSITION": 0, "JOINTS_0": 1, "WEIGHTS_0": 2}, "NORMAL": 0, "TANGENT": 0, "TEXCOORD_0": 0,
      "COLOR_0": 0, "JOINTS_1": 0, "WEIGHTS_1": 0, "skeleton": 0, "joints": [0, 1], "inverseBindMatrices": 0,
      "interpolation": "CUBICSPLINE", "path": "weights", "node": 0, "sampler": 0, "input": 0, "output": 1,
      "animations": [{"samplers": [{"input": 0, "output": 1}], "channels": [{"sampler": 0, "target":
        {"node": 0, "path": "rotation"}}]}], "skins": [{"joints": [0]}], "nodes": [{}], "scenes": [{"nodes": [0]}],
      "uri": "data:application/octet-stream;base64,AAAA", "bufferView": 0, "mimeType": "image/png",
      "extensionsRequired": ["KHR_texture_basisu"], "extras": {"targetNames": ["a"]}})";
    constexpr const char* kExtensions = R"([{"KHR_animation_pointer": {"pointer": "/nodes/0/weights/0"}},
      {"KHR_lights_punctual": {"light": 0, "lights": [{"type": "spot", "spot": {"outerConeAngle": 0.5}}]}},
      {"EXT_mesh_gpu_instancing": {"attributes": {"TRANSLATION": 0, "ROTATION": 1}}}, {"KHR_node_visibility":
      {"visible": false}}, {"KHR_meshopt_compression": {"buffer": 0, "byteLength": 64, "byteStride": 4, "count": 4,
      "mode": "ATTRIBUTES", "filter": "COLOR"}}, {"KHR_draco_mesh_compression": {"bufferView": 0, "attributes":
      {"POSITION": 0}}}, {"KHR_materials_variants": {"variants": [{"name": "a"}], "mappings": [{"material": 0,
      "variants": [0]}]}}, {"KHR_materials_pbrSpecularGlossiness": {"glossinessFactor": 0.5}},
      {"KHR_texture_transform": {"scale": [2, 2], "texCoord": 1}}, {"EXT_texture_webp": {"source": 0}},
      {"VRMC_vrm": {"humanoid": {"humanBones": {"hips": {"node": 0}}}, "expressions": {"preset": {"aa":
      {"morphTargetBinds": [{"node": 0, "index": 0}]}}}}}, {"VRMC_springBone": {"colliders": [{"node": 0, "shape":
      {"sphere": {"radius": 1}}}], "colliderGroups": [{"colliders": [0]}], "springs": [{"joints": [{"node": 0}],
      "colliderGroups": [0]}]}}, {"VRMC_node_constraint": {"constraint": {"roll": {"source": 0, "rollAxis": "X"}}}},
      {"VRM": {"blendShapeMaster": {"blendShapeGroups": [{"presetName": "joy", "binds": [{"mesh": 0}]}]},
      "secondaryAnimation": {"boneGroups": [{"bones": [0], "colliderGroups": [0]}], "colliderGroups": [{"node": 0,
      "colliders": [{"radius": 1}]}]}}}])";
    std::vector<std::pair<std::string, Json>> out;
    const Json members = Json::parse(kMembers), extensions = Json::parse(kExtensions);
    for (const auto& [name, value] : members.items()) out.emplace_back(name, value);
    for (const Json& extension : extensions) out.emplace_back("extensions", extension);
    return out;
  }();
  return known;
}

void change_object(Json& value, test::FixedRandom& random) {
  if (random.below(2) == 0) {
    const auto& known = known_members();
    const auto& [name, added] = known[random.below(static_cast<std::uint32_t>(known.size()))];
    if (added.is_object() && value.contains(name) && value[name].is_object())
      value[name].update(added);
    else
      value[name] = added;
    return;
  }
  if (value.empty()) return;
  const auto at = [&] { return std::next(value.begin(), random.below(static_cast<std::uint32_t>(value.size()))); };
  if (random.below(2) == 0)
    value.erase(at());
  else
    std::swap(*at(), *at());
}

void change_any_value(Json& document, test::FixedRandom& random, const MutateBytes& mutate_bytes) {
  std::vector<Json*> values;
  list_values(document, 0, values);
  const auto any = [&]() -> Json& { return *values[random.below(static_cast<std::uint32_t>(values.size()))]; };
  Json& value = any();
  if (random.below(8) == 0)
    value = Json(any());
  else if (value.is_number())
    change_number(value, random);
  else if (value.is_string())
    change_string(value, mutate_bytes);
  else if (value.is_array())
    change_array(value, random);
  else if (value.is_object())
    change_object(value, random);
  else
    value = odd_value(random);
}

}  // namespace

std::string mutate_json(const std::string& text, std::uint64_t seed, const MutateBytes& mutate_bytes) {
  // libFuzzer changes an input several times in a row; parsing it each time would cost more than all changes.
  static std::string last_text;
  static Json last_document;
  const std::string_view trimmed = std::string_view(text).substr(0, text.find_last_not_of(' ') + 1);
  Json document =
      !trimmed.empty() && trimmed == last_text ? std::move(last_document) : Json::parse(trimmed, nullptr, false);
  if (document.is_discarded()) return text;
  test::FixedRandom random(seed);
  for (std::uint32_t changes = 1 + random.below(3); changes > 0; --changes)
    change_any_value(document, random, mutate_bytes);
  last_text = document.dump(-1, ' ', false, Json::error_handler_t::ignore);
  last_document = std::move(document);
  return last_text;
}

}  // namespace sinew::fuzz
