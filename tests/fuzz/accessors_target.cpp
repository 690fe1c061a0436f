// SPDX-License-Identifier: MIT
// Input: fields of fixed size that describe views, accessors and their uses, then the bytes of the buffer. The JSON
// around them is always valid, so every input reaches the accessor rules.
#include <array>
#include <vector>

#include <nlohmann/json.hpp>

#include "tests/fuzz/import_target.h"
#include "tests/fuzz/input_reader.h"
#include "tests/importer/glb_seeds.h"

namespace sinew::fuzz {
namespace {

using Json = nlohmann::json;

constexpr std::array<int, 6> kComponents{5126, 5121, 5123, 5125, 5120, 5122};
constexpr std::array<const char*, 7> kTypes{"VEC3", "SCALAR", "VEC4", "VEC2", "MAT4", "MAT3", "MAT2"};
constexpr std::array<const char*, 3> kInterpolations{"LINEAR", "STEP", "CUBICSPLINE"};
constexpr std::array<const char*, 4> kPaths{"translation", "rotation", "scale", "weights"};
constexpr std::array<const char*, 8> kSemantics{"NORMAL",   "TANGENT",   "TEXCOORD_0", "COLOR_0",
                                                "JOINTS_0", "WEIGHTS_0", "JOINTS_1",   "WEIGHTS_1"};
constexpr std::uint32_t kNoUse = 0;  // a zero byte means no accessor, others name one

class AccessorFile {
 public:
  explicit AccessorFile(Bytes input) : in_(input) {}

  std::vector<std::byte> glb() {
    for (std::uint32_t n = 1 + in_.u8() % 6; n > 0; --n) add_view();
    for (std::uint32_t n = 1 + in_.u8() % 12; n > 0; --n) add_accessor();
    add_uses();
    std::vector<std::byte> bin(in_.rest().begin(), in_.rest().end());
    root_["buffers"] = Json::array({{{"byteLength", bin.size()}}});
    return test::make_glb(root_.dump(), std::move(bin));
  }

 private:
  void add_view() {
    Json view{{"buffer", 0}, {"byteOffset", in_.u16()}, {"byteLength", 1 + in_.u16()}};
    if (const std::uint32_t stride = in_.u8(); stride != 0) view["byteStride"] = stride;
    root_["bufferViews"].push_back(std::move(view));
  }

  std::uint32_t any_view() { return in_.u8() % static_cast<std::uint32_t>(root_["bufferViews"].size()); }

  void add_accessor() {
    Json accessor{{"componentType", in_.one_of(kComponents)}, {"type", in_.one_of(kTypes)}, {"count", 1 + in_.u16()}};
    const std::uint32_t flags = in_.u8();
    if ((flags & 1) == 0) accessor["bufferView"] = any_view();
    if ((flags & 1) == 0) accessor["byteOffset"] = in_.u16();
    if ((flags & 2) != 0) accessor["normalized"] = true;
    if ((flags & 4) != 0)
      accessor["sparse"] = {
          {"count", 1 + in_.u8()},
          {"indices",
           {{"bufferView", any_view()}, {"byteOffset", in_.u8()}, {"componentType", 5121 + 2 * (in_.u8() % 3)}}},
          {"values", {{"bufferView", any_view()}, {"byteOffset", in_.u8()}}}};
    if ((flags & 8) != 0) {
      accessor["min"] = {0};
      accessor["max"] = {1};
    }
    root_["accessors"].push_back(std::move(accessor));
  }

  void use(Json& object, const char* name) {
    if (const std::uint32_t choice = in_.u8(); choice != kNoUse) object[name] = any_accessor(choice);
  }
  std::uint32_t any_accessor(std::uint32_t choice) const {
    return choice % static_cast<std::uint32_t>(root_.at("accessors").size());
  }

  void add_uses() {
    Json attributes{{"POSITION", any_accessor(in_.u8())}}, primitive = Json::object(),
                                                           skin{{"joints", Json::array({1, 2})}};
    for (const char* semantic : kSemantics) use(attributes, semantic);
    primitive["attributes"] = std::move(attributes);
    use(primitive, "indices");
    primitive["mode"] = in_.u8() % 7;
    for (std::uint32_t n = in_.u8() % 3; n > 0; --n) {
      Json target = Json::object();
      for (const char* semantic : {"POSITION", "NORMAL", "TANGENT"}) use(target, semantic);
      primitive["targets"].push_back(std::move(target));
    }
    use(skin, "inverseBindMatrices");
    root_["meshes"] = Json::array({{{"primitives", Json::array({std::move(primitive)})}}});
    root_["skins"] = Json::array({std::move(skin)});
    root_["nodes"] = Json::array({{{"mesh", 0}, {"skin", 0}}, {{"children", Json::array({2})}}, Json::object()});
    add_animation();
  }

  void add_animation() {
    Json samplers = Json::array(), channels = Json::array();
    for (std::uint32_t n = in_.u8() % 4; n > 0; --n) {
      channels.push_back(
          {{"sampler", samplers.size()}, {"target", {{"node", in_.u8() % 3}, {"path", in_.one_of(kPaths)}}}});
      samplers.push_back({{"input", any_accessor(in_.u8())},
                          {"output", any_accessor(in_.u8())},
                          {"interpolation", in_.one_of(kInterpolations)}});
    }
    if (!channels.empty())
      root_["animations"] = Json::array({{{"samplers", std::move(samplers)}, {"channels", std::move(channels)}}});
  }

  InputReader in_;
  Json root_{{"asset", {{"version", "2.0"}}}};
};

}  // namespace

std::vector<std::byte> accessor_file(Bytes input) { return AccessorFile(input).glb(); }

void read_accessors(Bytes input) { import_and_evaluate(accessor_file(input)); }

}  // namespace sinew::fuzz
