// SPDX-License-Identifier: MIT
// Reading a document's lists from checked JSON.
#include "importer/file/read_document.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <string>

#include "importer/file/document_size.h"
#include "importer/file/gltf_shape.h"
#include "importer/file/parse_json.h"
#include "tests/importer/tiny_gltf.h"
#include "tests/support/fixed_random.h"

namespace sinew::test {
namespace {

/// A JSON tree, and the text that its strings point into.
struct CheckedText {
  std::unique_ptr<const std::string> text;
  std::unique_ptr<JsonTree> json;

  JsonTree* operator->() const { return json.get(); }
};

CheckedText checked(const std::string& text) {
  IssueLog log;
  CheckedText out{std::make_unique<const std::string>(text), nullptr};
  out.json = parse_json(bytes_of(*out.text), log);
  check_shape(out->root, gltf_shape(), "", log);
  EXPECT_EQ(log.error_count(), 0u) << text.substr(0, 200);
  return out;
}

TEST(read_document, T10_numbers_keep_every_bit) {
  FixedRandom random(5);
  Json root{{"asset", {{"version", "2.0"}}}};
  std::vector<double> numbers{0.0, -0.0, 5e-324, 3.4028234663852886e38, 0.1, 1.0 / 3.0};
  for (int i = 0; i < 20'000; ++i) numbers.push_back((random.unit() - 0.5) * std::pow(10.0, random.in(-320, 38)));
  root["nodes"] = Json::array({{{"weights", numbers}}});
  const gltf::Document document = read_document(checked(root.dump())->root);
  ASSERT_EQ(document.nodes[0].weights.size(), numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    EXPECT_EQ(document.nodes[0].weights[i], numbers[i]);
    EXPECT_EQ(std::signbit(document.nodes[0].weights[i]), std::signbit(numbers[i])) << numbers[i];
  }
}

TEST(read_document, entries_of_long_lists_keep_their_order) {
  constexpr std::uint32_t kCount = 3000;
  Json root{{"asset", {{"version", "2.0"}}}};
  for (std::uint32_t i = 0; i < kCount; ++i) {
    const Json extension{{"X", {{"i", i}}}};
    root["nodes"].push_back({{"name", "node " + std::to_string(i)}, {"extensions", extension}});
    root["materials"].push_back({{"alphaCutoff", i}, {"normalTexture", {{"index", i}, {"extensions", extension}}}});
    root["meshes"].push_back({{"primitives", {{{"attributes", {{"POSITION", i}}}, {"indices", i}}}}});
    root["samplers"].push_back({{"wrapS", i}});
  }
  const gltf::Document document = read_document(checked(root.dump())->root);
  ASSERT_EQ(document.nodes.size(), kCount);
  ASSERT_EQ(document.materials.size(), kCount);
  ASSERT_EQ(document.meshes.size(), kCount);
  ASSERT_EQ(document.samplers.size(), kCount);
  for (std::uint32_t i = 0; i < kCount; ++i) {
    EXPECT_EQ(document.nodes[i].name, "node " + std::to_string(i));
    EXPECT_EQ(document.nodes[i].extensions["X"]["i"], i);
    EXPECT_EQ(document.materials[i].alphaCutoff, i);
    const gltf::TextureInfo normal = texture_info(document.materials[i], TextureSlot::normal);
    EXPECT_EQ(normal.index, i);
    EXPECT_EQ((*normal.extensions)["X"]["i"], i);
    EXPECT_EQ(document.meshes[i].primitives[0].attributes.at("POSITION"), static_cast<int>(i));
    EXPECT_EQ(document.meshes[i].primitives[0].indices, static_cast<int>(i));
    EXPECT_EQ(document.samplers[i].wrapS, static_cast<int>(i));
  }
}

TEST(read_document, each_of_translation_rotation_and_scale_is_seen_beside_a_matrix) {
  const std::string head = R"({"asset": {"version": "2.0"}, "nodes": [{"matrix": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1])";
  EXPECT_FALSE(read_document(checked(head + "}]}")->root).nodes[0].has_trs);
  for (const char* beside : {R"("translation": [0, 0, 0])", R"("rotation": [0, 0, 0, 1])", R"("scale": [1, 1, 1])"}) {
    const gltf::Document document = read_document(checked(head + ", " + beside + "}]}")->root);
    EXPECT_TRUE(document.nodes[0].has_trs && document.nodes[0].matrix.size() == 16) << beside;
  }
}

TEST(read_document, the_last_of_a_name_counts_and_integers_may_have_a_fraction) {
  const gltf::Document document = read_document(
      checked(R"({"asset": {"version": "2.0"}, "nodes": [{"children": [1.0, 2e0], "name": "a", "name": "b"}, {}, {}],
                  "skins": [{"joints": [1], "joints": [2]}], "scenes": [{"nodes": [0.0]}], "scene": 0.0})")
          ->root);
  EXPECT_EQ(document.nodes[0].name, "b");
  EXPECT_EQ(document.nodes[0].children, (std::vector<int>{1, 2}));
  EXPECT_EQ(document.skins[0].joints, std::vector<int>{2});
  EXPECT_EQ(document.scenes[0].nodes, std::vector<int>{0});
  EXPECT_EQ(document.scene, 0u);
}

TEST(read_document, a_camera_without_lens_has_one_of_zeros) {
  const gltf::Document document = read_document(
      checked(R"({"asset": {"version": "2.0"}, "cameras": [{"name": "c", "type": "orthographic"}]})")->root);
  EXPECT_EQ(document.cameras[0].name, "c");
  EXPECT_EQ(document.cameras[0].type, "orthographic");
  EXPECT_EQ(document.cameras[0].orthographic, tinygltf::OrthographicCamera());
}

TEST(document_size, counts_entries_and_primitives) {
  const std::string head = R"({"asset": {"version": "2.0"})";
  EXPECT_EQ(entry_bytes(checked(head + "}")->root), 0u);
  EXPECT_EQ(entry_bytes(checked(head + R"(, "materials": [{}, {}], "nodes": [{}]})")->root),
            2 * sizeof(gltf::Material) + sizeof(gltf::Node));
  const std::string primitive = R"({"attributes": {"POSITION": 0}})";
  EXPECT_EQ(
      entry_bytes(checked(head + R"(, "meshes": [{"primitives": [)" + primitive + "," + primitive + "]}]}")->root),
      sizeof(gltf::Mesh) + 2 * sizeof(gltf::Primitive));
}

}  // namespace
}  // namespace sinew::test
