// SPDX-License-Identifier: MIT
// Properties of glTF files that common parsers do not check or read wrongly; the importer handles them itself.
#include <gtest/gtest.h>
#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "tests/importer/tiny_gltf.h"

namespace sinew::test {
namespace {

TEST(parser_traps, T4_sparse_accessors_are_applied_and_zeros_lie_beneath) {
  TinyGltf file;
  Json& primitive = file.add_triangle();
  const std::size_t indices = file.add_view(std::vector<std::uint8_t>{2}),
                    values = file.add_view(std::vector<float>{7, 8, 9});
  file.root["accessors"].push_back({{"componentType", 5126},
                                    {"count", 3},
                                    {"type", "VEC3"},
                                    {"sparse",
                                     {{"count", 1},
                                      {"indices", {{"bufferView", indices}, {"componentType", 5121}}},
                                      {"values", {{"bufferView", values}}}}}});
  primitive["targets"] = Json::array({{{"POSITION", file.root["accessors"].size() - 1}}});
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  const auto& moved = result->scene.meshes[0].primitives[0].morphs.targets[0].positions;
  ASSERT_EQ(moved.vertices.size(), 1u);
  EXPECT_EQ(moved.deltas[0], glm::vec3(7, 8, 9));
}

TEST(parser_traps, T4_double_components_that_the_parser_takes_are_refused) {
  TinyGltf file;
  file.scalars({1, 2});
  file.root["accessors"][0]["componentType"] = 5130;
  EXPECT_EQ(outcome(file.import()), "json-type at /accessors/0/componentType");
}

TEST(parser_traps, T8_data_uris_of_image_types_unknown_to_the_parser_arrive) {
  const std::string webp = "UklGRiQAAABXRUJQVlA4IBgAAAAwAQCdASoBAAEAAwA0JaQAA3AA/vuUAAA=";  // 1 x 1 pixel
  const std::string text = R"({"asset":{"version":"2.0"},"nodes":[{}],"images":[{"uri":"data:image/webp;base64,)" +
                           webp + R"("},{"uri":"data:image/ktx2;base64,AAAA"}]})";
  const auto result = import_gltf(bytes_of(text), "x");
  ASSERT_EQ(outcome(result), "ok");
  EXPECT_EQ(result->scene.images[0].rgba.size(), 4u);
  EXPECT_EQ(result->scene.images[0].mime_type, "image/webp");
  EXPECT_TRUE(warns(result, "image-missing", "/images/1"));
  EXPECT_EQ(result->scene.skeleton.joint_count(), 1u) << "the rest of the file loads";
}

TEST(parser_traps, T10_numbers_become_the_nearest_floats) {
  const auto result = import_gltf(
      bytes_of(
          R"({"asset":{"version":"2.0"},"nodes":[{"translation":[0.1,16777217,-1e-45],"scale":[3.4028234663852886e38,1e-60,1]}]})"),
      "x");
  ASSERT_EQ(outcome(result), "ok");
  const Transform& rest = result->scene.skeleton.rest[0];
  EXPECT_EQ(rest.translation, glm::vec3(0.1f, 16777216.0f, -0x1p-149f));
  EXPECT_EQ(rest.scale, glm::vec3(0x1.fffffep127f, 0.0f, 1.0f));
}

TEST(parser_traps, T11_the_bytes_of_a_large_glb_are_not_copied) {
  constexpr std::size_t kBytes = std::size_t{32} << 20;
  std::string json =
      R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":)" + std::to_string(kBytes) +
      R"(}],"bufferViews":[{"buffer":0,"byteLength":36}],"accessors":[{"bufferView":0,"componentType":5126,"count":3,)"
      R"("type":"VEC3"}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}]})";
  json.resize((json.size() + 3) / 4 * 4, ' ');
  const auto number = [](std::size_t n) {
    std::string out;
    for (int shift = 0; shift < 32; shift += 8) out += static_cast<char>(n >> shift & 255);
    return out;
  };
  const std::string file = "glTF" + number(2) + number(12 + 8 + json.size() + 8 + kBytes) + number(json.size()) +
                           "JSON" + json + number(kBytes) + std::string("BIN\0", 4) + std::string(kBytes, '\0');
  const auto held = [] {
    const auto info = mallinfo2();
    return info.uordblks + info.hblkhd;
  };
  std::size_t most = 0;
  const std::size_t before = held();
  ImportOptions options;
  std::size_t looks = 0;
  options.progress = [&](const char*, double) {
    ++looks;
    most = std::max(most, held());
  };
  const auto result = import_gltf(bytes_of(file), "large.glb", options);
  ASSERT_EQ(outcome(result), "ok");
  EXPECT_GT(looks, 2u) << "while it was read and after";
  EXPECT_LT(most, before + kBytes / 8);
}

}  // namespace
}  // namespace sinew::test
