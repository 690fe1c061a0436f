// SPDX-License-Identifier: MIT
// Rewriting files with Draco streams to files without.
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "tests/importer/rewritten.h"
#include "tests/importer/tiny_draco.h"
#include "tests/support/scene_equality.h"

namespace sinew::test {
namespace {

/// Values with the rounding that quantisation leaves: colours just outside of [0, 1], weights whose sum is not quite 1,
/// tangents whose handedness is not quite 1 or -1.
const TriangleValues kRounded{{"POSITION", {0, 0, 0, 1, 0, 0, 0, 1, 0}},
                              {"COLOR_0", {1.0009765f, 0, 0, -0.0009765f, 0.5f, 1, 0, 0, 1}},
                              {"NORMAL", {0, 0, 1, 0, 0, 1, 0, 0, 1}},
                              {"TANGENT", {1, 0, 0, 0.9990234f, 1, 0, 0, -1.0009765f, 1, 0, 0, 1}},
                              {"JOINTS_0", {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}},
                              {"WEIGHTS_0", {1.0009765f, 0, 0, 0, 0.5009765f, 0.5f, 0, 0, 1, 0, 0, 0}}};

TEST(rewrite_draco, G62_draco_becomes_plain_accessors_within_the_limits_of_gltf) {
  const TinyGltf gltf = draco_document(kRounded);
  const auto file = gltf.import(carrying());
  ASSERT_TRUE(file);
  EXPECT_TRUE(warns(file, "draco-range", "/meshes/0/primitives/0"));
  const auto out = rewrite_gltf(*file);
  ASSERT_TRUE(out) << out.error().issue.detail;
  const GlbParts parts = split_glb(out->file);
  EXPECT_FALSE(parts.json.contains("extensionsUsed") || parts.json.contains("extensionsRequired"));
  EXPECT_FALSE(parts.json["meshes"][0]["primitives"][0].contains("extensions"));
  const auto plain = import_gltf(out->file, "plain.glb");
  ASSERT_TRUE(plain) << plain.error().issue.detail;
  expect_equal(file->scene, plain->scene);
  for (const ImportIssue& warning : plain->warnings) EXPECT_NE(warning.rule, "weights-sum") << warning.detail;
  const Primitive& primitive = plain->scene.meshes[0].primitives[0];
  ASSERT_EQ(primitive.vertex_count(), 3u);
  for (const glm::vec4& color : primitive.colors)
    for (int c = 0; c < 4; ++c) EXPECT_TRUE(color[c] >= 0.0f && color[c] <= 1.0f) << color[c];
}

TEST(rewrite_draco, G62_decoded_elements_begin_where_their_own_view_does) {
  TinyGltf gltf = draco_document(kRounded);
  Json& position = gltf.root["accessors"][gltf.root["meshes"][0]["primitives"][0]["attributes"]["POSITION"].get<int>()];
  position["bufferView"] = gltf.add_view(std::vector<float>(12));  // fallback data for readers without the extension
  position["byteOffset"] = 12;
  const GlbParts out = rewritten(gltf);
  const Json& primitive = out.json["meshes"][0]["primitives"][0];
  const Json& written = out.json["accessors"][primitive["attributes"]["POSITION"].get<std::size_t>()];
  EXPECT_EQ(written.value("byteOffset", 0), 0);
  EXPECT_EQ(out.view(written["bufferView"].get<std::size_t>()).size(), 36u);
}

TEST(rewrite_draco, G62_a_compressed_strip_is_written_as_the_triangles_that_it_becomes) {
  TinyGltf gltf = draco_document(kRounded);
  Json& primitive = gltf.root["meshes"][0]["primitives"][0];
  EXPECT_FALSE(rewritten(gltf).json["meshes"][0]["primitives"][0].contains("mode"));
  primitive["mode"] = 5;
  EXPECT_EQ(rewritten(gltf).json["meshes"][0]["primitives"][0]["mode"], 4);
}

TEST(rewrite_draco, G62_an_accessor_that_two_streams_fill_is_written_twice_with_all_it_says) {
  TinyGltf gltf = draco_document(kRounded);
  Json& primitives = gltf.root["meshes"][0]["primitives"];
  TriangleValues moved = kRounded;
  for (float& x : moved["POSITION"]) x += 5.0f;
  std::map<std::string, int> ids;
  primitives.push_back(primitives[0]);
  primitives[1]["extensions"]["KHR_draco_mesh_compression"] = {
      {"bufferView", gltf.add_view(draco_triangle(moved, ids))}, {"attributes", ids}};
  Json& position = gltf.root["accessors"][primitives[0]["attributes"]["POSITION"].get<std::size_t>()];
  position.update({{"name", "places"}, {"min", {0, 0, 0}}, {"max", {1, 1, 0}}});
  const Json out = rewritten(gltf).json;
  for (const std::size_t p : {0u, 1u}) {
    const std::size_t written = out["meshes"][0]["primitives"][p]["attributes"]["POSITION"];
    EXPECT_EQ(out["accessors"][written]["name"], "places") << p;
    EXPECT_EQ(out["accessors"][written]["max"][0], p == 0 ? 1.0 : 6.0);
  }
}

TEST(rewrite_draco, G62_the_weights_of_all_sets_of_a_decoded_vertex_are_1_together) {
  TriangleValues values = kRounded;
  values["JOINTS_1"] = {1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1};
  for (const float half : {0.5f, 0.5009765f}) {
    values["WEIGHTS_0"] = {half, 0, 0, 0, 0.25f, 0.25f, 0, 0, 0, 0, 0, 0.5f};
    values["WEIGHTS_1"] = {0.5f, 0, 0, 0, 0, 0, 0.5f, 0, 0.25f, 0.25f, 0, 0};
    values.erase("COLOR_0");
    const auto file = draco_document(values).import(carrying());
    ASSERT_EQ(outcome(file), "ok");
    EXPECT_EQ(warns(file, "draco-range", "/meshes/0/primitives/0"), half != 0.5f);
    const auto plain = import_gltf(rewrite_gltf(*file)->file, "plain.glb");
    ASSERT_EQ(outcome(plain), "ok");
    EXPECT_FALSE(warns(plain, "weights-sum", "/meshes/0/primitives/0/attributes")) << half;
    EXPECT_EQ(plain->scene.meshes[0].primitives[0].influences.weights.size(), 6u) << half;
  }
}

TEST(rewrite_draco, G15_bounds_are_those_of_the_decoded_elements) {
  TinyGltf gltf = draco_document(kRounded);
  const std::size_t positions = gltf.root["meshes"][0]["primitives"][0]["attributes"]["POSITION"];
  for (const char* missing : {"neither", "min", "max"}) {
    Json& accessor = gltf.root["accessors"][positions];
    accessor["min"] = {-9, -9, -9};
    accessor["max"] = {9, 9, 9};
    accessor.erase(missing);
    const Json out = rewritten(gltf).json;
    EXPECT_EQ(out["accessors"][positions]["min"], Json::array({0.0, 0.0, 0.0})) << missing;
    EXPECT_EQ(out["accessors"][positions]["max"], Json::array({1.0, 1.0, 0.0})) << missing;
  }
}

}  // namespace
}  // namespace sinew::test
