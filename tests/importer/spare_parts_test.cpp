// SPDX-License-Identifier: MIT
// Faults in unused parts of a file: only a thorough import names them.
#include <gtest/gtest.h>

#include <limits>
#include <set>

#include "tests/importer/tiny_gltf.h"

namespace sinew::test {
namespace {

ImportOptions thorough() {
  ImportOptions options;
  options.thorough = true;
  return options;
}

/// "rule at /pointer" of each warning of a thorough import, which must succeed. A plain import must not warn, if
/// `silent_otherwise`.
std::set<std::string> warnings_of(const TinyGltf& file, bool silent_otherwise = true) {
  std::set<std::string> out;
  const auto result = file.import(thorough()), plain = file.import();
  EXPECT_EQ(outcome(result), "ok");
  EXPECT_EQ(outcome(plain), "ok");
  if (result)
    for (const ImportIssue& issue : result->warnings)
      if (issue.severity == Severity::warning) out.insert(issue.rule + " at " + issue.json_pointer);
  if (plain && silent_otherwise) {
    EXPECT_TRUE(plain->warnings.empty()) << describe("file", plain->warnings[0]);
  }
  return out;
}

using Found = std::set<std::string>;

TEST(spare_parts, strides_belong_to_vertices_and_fit_their_view) {
  TinyGltf file;
  const std::size_t small = file.add_view(std::vector<float>(4)), indices = file.add_view(std::vector<float>(4)),
                    vertices = file.add_view(std::vector<float>(4));
  file.root["bufferViews"][small]["byteStride"] = 20;
  file.root["bufferViews"][indices]["byteStride"] = 8;
  file.root["bufferViews"][indices]["target"] = 34963;
  file.root["bufferViews"][vertices]["byteStride"] = 8;
  file.root["bufferViews"][vertices]["target"] = 34962;
  EXPECT_EQ(warnings_of(file), (Found{"buffer-view-stride at /bufferViews/0/byteStride",
                                      "buffer-view-stride at /bufferViews/1/byteStride"}));
}

TEST(spare_parts, strides_are_multiples_of_four_up_to_252) {
  for (const auto& [stride, is_right] : {std::pair(4, true), {252, true}, {6, false}, {250, false}, {256, false}}) {
    TinyGltf file;
    const std::size_t view = file.add_view(std::vector<float>(512));
    file.root["bufferViews"][view]["byteStride"] = stride;
    file.root["bufferViews"][view]["target"] = 34962;
    EXPECT_EQ(warnings_of(file, false).contains("buffer-view-stride at /bufferViews/0/byteStride"), !is_right)
        << stride;
  }
}

TEST(spare_parts, extensions_are_objects_declared_and_listed_once) {
  TinyGltf file;
  file.root = Json::parse(R"({"asset": {"version": "2.0"}, "extensionsUsed": ["A", "B", "A"],
    "extensions": {"A": {}, "B": 3, "C": {"extensions": {"D": {}}}, "E/~": {}}, "nodes": [{"extensions": {"C": {}}}],
    "skins": [{"joints": [0], "extensions": {"F": []}}], "extras": {"extensions": {"G": {}}}})");
  EXPECT_EQ(warnings_of(file, false),
            (Found{"extension-duplicate at /extensionsUsed/2", "extension-value at /extensions/B",
                   "extension-undeclared at /extensions/C", "extension-undeclared at /extensions/C/extensions/D",
                   "extension-undeclared at /extensions/E~1~0", "extension-value at /skins/0/extensions/F",
                   "extension-undeclared at /skins/0/extensions/F"}));
}

TEST(spare_parts, a_required_extension_is_also_used) {
  TinyGltf file;
  file.root["extensionsRequired"] = {"KHR_node_visibility"};
  file.root["nodes"] = {{{"extensions", {{"KHR_node_visibility", {{"visible", true}}}}}}};
  EXPECT_EQ(warnings_of(file), Found{"extension-undeclared at /extensionsRequired"});
}

TEST(spare_parts, an_offset_needs_a_view) {
  TinyGltf file;
  file.root["accessors"] = {{{"componentType", 5126}, {"count", 1}, {"type", "SCALAR"}, {"byteOffset", 0}}};
  EXPECT_EQ(warnings_of(file), Found{"accessor-offset at /accessors/0/byteOffset"});
}

TEST(spare_parts, floats_that_nothing_uses_are_finite) {
  TinyGltf file;
  Json& primitive = file.add_triangle();
  const std::size_t position = primitive["attributes"]["POSITION"];
  file.root["accessors"][position]["min"] = {0, 0, 0};
  file.root["accessors"][position]["max"] = {1, 1, 0};
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
  file.scalars({1, 2});
  file.scalars({1, nan});
  primitive["attributes"]["_OWN"] = file.vec3({1, 2, 3, 4, infinite, 6, 7, 8, 9});
  EXPECT_EQ(warnings_of(file), (Found{"not-finite at /accessors/2", "not-finite at /accessors/3"}));
}

TEST(spare_parts, floats_that_are_used_are_reported_where_they_are_used) {
  TinyGltf file;
  file.add_triangle();
  file.root["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] =
      file.vec3(std::vector<float>(9, std::numeric_limits<float>::infinity()));
  const auto result = file.import(thorough());
  EXPECT_EQ(outcome(result), "not-finite at /meshes/0/primitives/0/attributes/NORMAL");
  EXPECT_TRUE(result.error().more_errors.empty());
  for (const ImportIssue& warning : result.error().warnings) EXPECT_NE(warning.rule, "not-finite");
}

TEST(spare_parts, data_uris_hold_data_of_a_type_that_fits) {
  TinyGltf file;
  file.root["buffers"] = Json::parse(R"([
    {"byteLength": 0, "uri": "data:application/octet-stream;base64,"},
    {"byteLength": 2, "uri": "data:image/png;base64,YWI="},
    {"byteLength": 2, "uri": "data:application/gltf-buffer;base64,YWI="},
    {"byteLength": 2, "uri": "data:application/octet-stream;base64,YWI="}])");
  EXPECT_EQ(warnings_of(file), (Found{"data-uri at /buffers/0/uri", "data-uri at /buffers/1/uri"}));
  TinyGltf images;
  images.root["images"] = {{{"uri", "data:text/plain;base64,YWI="}}, {{"uri", "data:image/png;base64,YWI="}}};
  const Found found = warnings_of(images, false);
  EXPECT_TRUE(found.contains("data-uri at /images/0/uri"));
  EXPECT_FALSE(found.contains("data-uri at /images/1/uri"));
}

TEST(spare_parts, positions_have_bounds) {
  TinyGltf file;
  file.add_triangle();
  EXPECT_EQ(warnings_of(file), Found{"mesh-position-bounds at /meshes/0/primitives/0/attributes/POSITION"});
  Json& primitives = file.root["meshes"][0]["primitives"];
  primitives.insert(primitives.begin(), Json{{"attributes", {{"_OWN", file.scalars({1})}}}});
  EXPECT_TRUE(warnings_of(file, false).contains("mesh-position-bounds at /meshes/0/primitives/1/attributes/POSITION"));
}

/// Nodes in the tree 0 - (1 - 2, 3), and node 4 alone.
TinyGltf skinned(std::vector<int> joints, int skeleton) {
  TinyGltf file;
  file.root["nodes"] = Json::parse(R"([{"children": [1, 3]}, {"children": [2]}, {}, {}, {}])");
  file.root["skins"] = {{{"joints", joints}, {"skeleton", skeleton}}};
  return file;
}

TEST(spare_parts, G30_the_skeleton_of_a_skin_is_above_all_of_its_joints) {
  for (const auto& [joints, skeleton] : std::vector<std::pair<std::vector<int>, int>>{
           {{1, 2, 3}, 0}, {{0, 1}, 0}, {{2}, 1}, {{2}, 2}, {{1, 2}, 1}, {{4}, 4}})
    EXPECT_EQ(warnings_of(skinned(joints, skeleton)), Found{}) << skeleton;
  for (const auto& [joints, skeleton] : std::vector<std::pair<std::vector<int>, int>>{
           {{1, 2, 3}, 1}, {{0, 1}, 1}, {{2}, 3}, {{1}, 2}, {{1}, 4}, {{4}, 0}})
    EXPECT_EQ(warnings_of(skinned(joints, skeleton), false), Found{"skin-skeleton at /skins/0/skeleton"}) << skeleton;
}

TEST(spare_parts, G30_the_skeleton_of_each_skin_is_looked_at) {
  TinyGltf file = skinned({1, 2, 3}, 0);
  Json& skins = file.root["skins"];
  skins.insert(skins.begin(), Json{{"joints", {1}}});
  skins.push_back({{"joints", {2}}, {"skeleton", 3}});
  EXPECT_EQ(warnings_of(file, false), Found{"skin-skeleton at /skins/2/skeleton"});
}

/// Places of the reports of severity info.
Found infos_of(const TinyGltf& file) {
  Found out;
  const auto result = file.import(thorough()), plain = file.import();
  EXPECT_EQ(outcome(result), "ok");
  for (const ImportIssue& issue : result->warnings)
    if (issue.severity == Severity::info) out.insert(issue.rule + " at " + issue.json_pointer);
  EXPECT_EQ(outcome(plain), "ok");
  for (const ImportIssue& issue : plain->warnings) EXPECT_NE(issue.severity, Severity::info) << issue.rule;
  return out;
}

TEST(spare_parts, objects_that_nothing_refers_to_are_named) {
  TinyGltf file;
  file.add_triangle();
  EXPECT_EQ(infos_of(file), Found{});
  file.scalars({1, 2});
  const std::string accessor = std::to_string(file.root["accessors"].size() - 1);
  for (const char* list : {"materials", "samplers", "textures"}) file.root[list] = Json::parse("[{}]");
  file.root["meshes"].push_back(file.root["meshes"][0]);
  file.root["cameras"] = Json::parse(R"([{"type": "perspective", "perspective": {"yfov": 1, "znear": 1}}])");
  file.root["extensionsUsed"] = {"KHR_lights_punctual"};
  file.root["extensions"]["KHR_lights_punctual"]["lights"] = Json::parse(R"([{"type": "point"}])");
  EXPECT_EQ(infos_of(file),
            (Found{"unused-object at /accessors/" + accessor, "unused-object at /cameras/0",
                   "unused-object at /extensions/KHR_lights_punctual/lights/0", "unused-object at /materials/0",
                   "unused-object at /meshes/1", "unused-object at /samplers/0", "unused-object at /textures/0"}));
}

TEST(spare_parts, what_an_extension_refers_to_is_used) {
  TinyGltf file;
  file.add_triangle();
  file.root["meshes"][0]["primitives"][0]["material"] = 0;
  file.root["textures"] = Json::parse("[{}, {}, {}]");
  file.root["materials"] = Json::parse(R"([{"extensions": {"KHR_materials_clearcoat":
    {"clearcoatTexture": {"index": 1, "texCoord": 0}}}}])");
  file.root["extensionsUsed"] = {"KHR_materials_clearcoat"};
  EXPECT_EQ(infos_of(file), (Found{"unused-object at /textures/0", "unused-object at /textures/2"}));
  file.root["extensionsUsed"].push_back("OWN_thing");
  file.root["nodes"][0]["extensions"]["OWN_thing"]["picture"] = {{"any", {2}}};
  EXPECT_EQ(infos_of(file), Found{"unused-object at /textures/0"})
      << "a number of an unknown extension may be an index";
  file.root["nodes"][0]["extras"]["extensions"]["OWN_thing"] = 0;
  EXPECT_EQ(infos_of(file), Found{"unused-object at /textures/0"}) << "what applications store refers to nothing";
}

TEST(spare_parts, nodes_that_no_scene_shows_are_named_by_their_roots) {
  TinyGltf file;
  file.root["nodes"] = Json::parse(R"([{"children": [1]}, {}, {"children": [3]}, {}])");
  EXPECT_EQ(infos_of(file), Found{}) << "without scenes all nodes are shown";
  file.root["scenes"] = Json::parse(R"([{"nodes": [0]}])");
  EXPECT_EQ(infos_of(file), Found{"node-outside-scenes at /nodes/2"});
  file.root["scenes"].push_back({{"nodes", {2}}});
  EXPECT_EQ(infos_of(file), Found{});
}

}  // namespace
}  // namespace sinew::test
