// SPDX-License-Identifier: MIT
// Rewriting vertex streams whose values are at the limits of smaller formats, and accessors that several primitives
// share.
#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>
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

/// A triangle whose streams all contain values up to `most`.
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

TEST(rewrite_limits, joints_up_to_255_become_bytes) {
  for (const std::uint16_t last : {std::uint16_t{255}, std::uint16_t{256}}) {
    TinyGltf gltf;
    Json& attributes = gltf.add_triangle()["attributes"];
    attributes["JOINTS_0"] =
        gltf.add(std::vector<std::uint16_t>{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, last}, "VEC4", 5123, 4);
    attributes["WEIGHTS_0"] = gltf.vec4({1, 0, 0, 0, 1, 0, 0, 0, .5f, 0, 0, .5f});
    const Json json = rewritten(gltf, quantized()).json;
    const std::size_t joints = json["meshes"][0]["primitives"][0]["attributes"]["JOINTS_0"];
    EXPECT_EQ(json["accessors"][joints]["componentType"], last == 255 ? 5121 : 5123) << last;
  }
}

TEST(rewrite_limits, weights_that_primitives_share_stay_floats_if_one_has_two_sets) {
  for (const bool has_two : {false, true}) {
    TinyGltf gltf;
    gltf.add_skinned_triangle(std::vector<std::uint8_t>(12), {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0});
    Json& primitives = gltf.root["meshes"][0]["primitives"];
    Json second = primitives[0];
    if (has_two) second["attributes"]["JOINTS_1"] = second["attributes"]["JOINTS_0"];
    if (has_two) second["attributes"]["WEIGHTS_1"] = gltf.vec4(std::vector<float>(12, 0.0f));
    primitives.insert(primitives.begin(), second);
    const Json json = rewritten(gltf, quantized()).json;
    for (const Json& primitive : json["meshes"][0]["primitives"])
      EXPECT_EQ(json["accessors"][primitive["attributes"]["WEIGHTS_0"].get<std::size_t>()]["componentType"],
                has_two ? 5126 : 5121);
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

/// With EXT_meshopt_compression, decoded views lie in a placeholder buffer without bytes in the file. They must not
/// overlap, and start at multiples of four.
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

/// The scene of a file, and the scene after quantized rewriting.
std::pair<Scene, Scene> recoded(const TinyGltf& gltf) {
  const auto out = rewrite(gltf, quantized());
  if (!out) throw std::runtime_error(describe("file", out.error().issue));
  auto before = gltf.import(), after = import_gltf(out->file, "recoded.glb");
  return {std::move(before.value().scene), std::move(after.value().scene)};
}

/// Positions of all triangle corners of the first mesh, over all its primitives.
std::vector<glm::vec3> corners(const Scene& scene) {
  std::vector<glm::vec3> out;
  for (const Primitive& primitive : scene.meshes.at(0).primitives)
    for (const std::uint32_t v : primitive.indices) out.push_back(primitive.positions[v]);
  return out;
}

/// Four vertices that the triangles name in another order than the vertex list.
TinyGltf turned_square() {
  TinyGltf gltf;
  Json& primitive = gltf.add_triangle();
  primitive["attributes"]["POSITION"] = gltf.vec3({0.6f, 0.8f, 0, 0, 0.28f, 0.96f, 0.8f, 0, -0.6f, 0, 0, 1});
  primitive["indices"] = gltf.add(std::vector<std::uint16_t>{2, 0, 3, 2, 3, 1}, "SCALAR", 5123, 1);
  return gltf;
}

TEST(rewrite_limits, nothing_moves_whatever_shares_its_numbers_or_lies_between_them) {
  const std::pair<const char*, std::function<void(TinyGltf&, Json&)>> changes[] = {
      {"nothing", [](TinyGltf&, Json&) {}},
      {"indices of two primitives",
       [](TinyGltf& gltf, Json& primitives) {
         primitives.push_back(primitives[0]);
         primitives[1]["attributes"]["POSITION"] = gltf.vec3({1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12});
       }},
      {"positions and normals",
       [](TinyGltf&, Json& primitives) {
         primitives[0]["attributes"]["NORMAL"] = primitives[0]["attributes"]["POSITION"];
       }},
      {"positions and places of copies",
       [](TinyGltf& gltf, Json& primitives) {
         gltf.root["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"]["attributes"]["TRANSLATION"] =
             primitives[0]["attributes"]["POSITION"];
         gltf.root["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
       }},
      {"numbers between those of vertices", [](TinyGltf& gltf, Json& primitives) {
         const std::size_t view = gltf.add_view(std::vector<float>{1, 2, 3, 9, 4, 5, 6, 9, 7, 8, 9, 9, 1, 1, 1, 9});
         gltf.root["bufferViews"][view]["byteStride"] = 16;
         gltf.root["accessors"][primitives[0]["attributes"]["POSITION"].get<std::size_t>()]["bufferView"] = view;
       }}};
  for (const auto& [what, change] : changes) {
    TinyGltf gltf = turned_square();
    change(gltf, gltf.root["meshes"][0]["primitives"]);
    const auto [before, after] = recoded(gltf);
    EXPECT_EQ(corners(before), corners(after)) << what;
    EXPECT_EQ(before.instances.at(0).copies, after.instances.at(0).copies) << what;
  }
}

TEST(rewrite_limits, small_elements_begin_at_multiples_of_four) {
  TinyGltf gltf = turned_square();
  Json& attributes = gltf.root["meshes"][0]["primitives"][0]["attributes"];
  attributes["COLOR_0"] = gltf.vec3({0, 0.2f, 1, 1, 0.4f, 0, 0.6f, 0, 1, 1, 1, 0});
  attributes["NORMAL"] = gltf.vec3({0, 0, 1, 0, 1, 0, 1, 0, 0, 0, 0, 1});
  const Json json = rewritten(gltf, quantized()).json;
  for (const char* name : {"COLOR_0", "NORMAL"}) {
    const Json& accessor = json["accessors"][json["meshes"][0]["primitives"][0]["attributes"][name].get<std::size_t>()];
    EXPECT_LT(accessor["componentType"], 5122) << name;
    EXPECT_EQ(accessor.value("byteOffset", 0) % 4, 0) << name;
    EXPECT_EQ(json["bufferViews"][accessor["bufferView"].get<std::size_t>()]["byteStride"], 4) << name;
  }
  const auto [before, after] = recoded(gltf);
  const auto colors = [](const Scene& scene) {
    const Primitive& primitive = scene.meshes[0].primitives[0];
    std::vector<glm::vec4> out;
    for (const std::uint32_t v : primitive.indices) out.push_back(primitive.colors[v]);
    return out;
  };
  EXPECT_EQ(colors(before), colors(after)) << "multiples of 1 / 255";
}

TEST(rewrite_limits, rotations_along_a_curve_stay_floats) {
  for (const char* interpolation : {"LINEAR", "STEP", "CUBICSPLINE"}) {
    const bool curve = std::string(interpolation) == "CUBICSPLINE";
    TinyGltf gltf;
    gltf.add_triangle();
    std::vector<float> keys{0, 0.5f, 0, 0, 0, 0, 0, 1};
    if (curve) keys.insert(keys.end(), {0, 0.25f, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0});
    gltf.animate("rotation", gltf.times({0, 1}), gltf.vec4(keys), interpolation);
    const Json json = rewritten(gltf, quantized()).json;
    const std::size_t output = json["animations"][0]["samplers"][0]["output"];
    EXPECT_EQ(json["accessors"][output]["componentType"], curve ? 5126 : 5122) << interpolation;
  }
}

}  // namespace
}  // namespace sinew::test
