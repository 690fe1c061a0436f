// SPDX-License-Identifier: MIT
// Streams at the limits of what their small forms can hold.
#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "tests/importer/rewritten.h"

namespace sinew::test {
namespace {

RewriteOptions quantized() {
  RewriteOptions options;
  options.quantize = true;
  return options;
}

/// A triangle whose streams all have numbers up to `most`.
TinyGltf numbers_up_to(float most) {
  TinyGltf gltf;
  const std::vector<float> weights{most, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
  Json& primitive = gltf.add_skinned_triangle(std::vector<std::uint8_t>(12), weights);
  Json& attributes = primitive["attributes"];
  attributes["COLOR_0"] = gltf.vec4(weights);
  attributes["NORMAL"] = gltf.vec3({0, 0, most, 0, 0, 1, 0, 0, 1});
  attributes["TANGENT"] = gltf.vec4({most, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1});
  attributes["TEXCOORD_0"] = gltf.add(std::vector<float>{most, 0, 0, 0, 1, 0}, "VEC2", 5126, 2);
  primitive["targets"] = Json::array({{{"NORMAL", gltf.vec3({0, 0, 0, most, 0, 0, 0, 0, 0})}}});
  gltf.animate("rotation", gltf.times({0, 1}), gltf.vec4({0, 0, 0, most, 0, 0, 0, 1}));
  return gltf;
}

TEST(rewrite_limits, numbers_beyond_one_stay_floats_and_others_become_small_integers) {
  for (const float most : {1.0f, 1.25f}) {
    const Json json = rewritten(numbers_up_to(most), quantized()).json;
    const Json& primitive = json["meshes"][0]["primitives"][0];
    std::vector<std::pair<std::string, Json>> streams{{"target", primitive["targets"][0]["NORMAL"]},
                                                      {"rotation", json["animations"][0]["samplers"][0]["output"]}};
    for (const char* name : {"COLOR_0", "NORMAL", "TANGENT", "TEXCOORD_0", "WEIGHTS_0"})
      streams.emplace_back(name, primitive["attributes"][name]);
    for (const auto& [name, accessor] : streams) {
      const bool floats = json["accessors"][accessor.get<std::size_t>()]["componentType"] == 5126;
      EXPECT_EQ(floats, most > 1.0f) << name;
    }
  }
}

TEST(rewrite_limits, the_index_that_would_restart_a_strip_takes_32_bits) {
  for (const std::uint32_t last : {65534u, 65535u}) {
    TinyGltf gltf;
    Json& primitive = gltf.add_triangle();
    gltf.root["accessors"].push_back({{"componentType", 5126}, {"count", 65536}, {"type", "VEC3"}});
    const std::size_t zeros = gltf.root["accessors"].size() - 1;
    primitive = {{"attributes", {{"POSITION", zeros}}}, {"mode", 0}};
    primitive["indices"] = gltf.add(std::vector<std::uint32_t>{0, last}, "SCALAR", 5125, 1);
    const Json json = rewritten(gltf, quantized()).json;
    const std::size_t indices = json["meshes"][0]["primitives"][0]["indices"];
    EXPECT_EQ(json["accessors"][indices]["componentType"], last < 65535 ? 5123 : 5125);
  }
}

/// EXT_meshopt_compression: decoded views lie in a buffer that no file holds, apart and as their numbers need it.
TEST(rewrite_limits, decoded_views_lie_apart_at_multiples_of_four) {
  TinyGltf gltf;
  constexpr std::uint16_t kCount = 401;  // an odd number of indices of two bytes
  std::vector<float> positions;
  std::vector<std::uint16_t> corners, places;
  for (std::uint16_t i = 0; i < kCount; ++i) {
    positions.insert(positions.end(), {static_cast<float>(i), 0, 1});
    places.push_back(i);
    for (const int k : {0, 1, 2}) corners.push_back(static_cast<std::uint16_t>((i + k) % kCount));
  }
  Json primitive{{"attributes", {{"POSITION", gltf.vec3(positions)}}}};
  primitive["indices"] = gltf.add(corners, "SCALAR", 5123, 1);
  Json points = primitive;
  points["mode"] = 0;
  points["indices"] = gltf.add(places, "SCALAR", 5123, 1);
  gltf.root["meshes"] = Json::array({{{"primitives", {primitive, points}}}});
  gltf.root["nodes"] = Json::array({{{"mesh", 0}}});
  RewriteOptions options;
  options.meshopt = true;
  const Json json = rewritten(gltf, options).json;
  std::size_t end = 0, compressed = 0;
  for (const Json& view : json["bufferViews"]) {
    if (!view.contains("extensions")) continue;
    const std::size_t offset = view.value("byteOffset", std::size_t{0});
    EXPECT_EQ(offset % 4, 0u);
    EXPECT_GE(offset, end);
    end = offset + view["byteLength"].get<std::size_t>();
    ++compressed;
  }
  EXPECT_EQ(compressed, 3u);
  EXPECT_GE(json["buffers"].back()["byteLength"].get<std::size_t>(), end);
}

}  // namespace
}  // namespace sinew::test
