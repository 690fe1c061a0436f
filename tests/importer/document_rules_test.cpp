// SPDX-License-Identifier: MIT
// Rules about the document itself: a file of a few lines breaks each one, and the import reports the rule and the
// pointer.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <string>
#include <vector>

#include "importer/rules.h"
#include "tests/importer/tiny_gltf.h"

namespace sinew::test {
namespace {

std::string import_text(const std::string& text) { return outcome(import_gltf(bytes_of(text), "x.gltf")); }

std::string import_json(const std::string& rest) {
  return import_text(std::string(R"({"asset":{"version":"2.0"},)") + rest + "}");
}

/// The errors in animations, which refuse no file.
std::string survived_json(const std::string& rest) {
  return survived(import_gltf(bytes_of(R"({"asset":{"version":"2.0"},)" + rest + "}"), "x.gltf"));
}

TEST(document_rules, the_smallest_document_is_an_empty_scene) {
  EXPECT_EQ(import_text(R"({"asset":{"version":"2.0"}})"), "ok");
}

TEST(document_rules, json_errors_name_the_place_in_the_text) {
  const auto result = import_gltf(bytes_of("{\"asset\":\n  oops}"), "x.gltf");
  ASSERT_FALSE(result);
  EXPECT_EQ(result.error().issue.rule, "json-syntax");
  EXPECT_NE(result.error().issue.detail.find("line 2"), std::string::npos) << result.error().issue.detail;
  EXPECT_EQ(result.error().file, "x.gltf");
  EXPECT_EQ(import_text("{"), "json-syntax at ");
  EXPECT_EQ(import_text("[]"), "json-type at ");
  EXPECT_EQ(import_text("{\"asset\":{\"version\":\"\xff\"}}"), "json-syntax at ") << "not UTF-8";
}

TEST(document_rules, numbers_that_are_none_in_accessors_that_nothing_uses_are_warned_of) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const auto warnings = [](const TinyGltf& file) {
    std::vector<std::string> told;
    const std::string text = file.text();
    const auto result = import_gltf(bytes_of(text), "x.gltf", {.thorough = true});
    EXPECT_TRUE(result);
    if (result)
      for (const ImportIssue& issue : result->warnings)
        if (issue.rule == "not-finite") told.push_back(issue.json_pointer + ' ' + issue.detail);
    return told;
  };
  const std::vector<std::string> second{"/accessors/0 element 1 holds NaN or infinity; nothing uses the accessor"};
  TinyGltf dense;
  dense.vec3({1, 2, 3, 4, nan, 6});
  EXPECT_EQ(warnings(dense), second);
  TinyGltf sparse;
  const std::size_t indices = sparse.add_view(std::vector<std::uint16_t>{1}),
                    values = sparse.add_view(std::vector{nan});
  sparse.root["accessors"] = Json::array({{{"componentType", 5126},
                                           {"count", 4},
                                           {"type", "SCALAR"},
                                           {"sparse",
                                            {{"count", 1},
                                             {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
                                             {"values", {{"bufferView", values}}}}}}});
  EXPECT_EQ(warnings(sparse), second);
  TinyGltf finite;
  finite.vec3({1, 2, 3, 4, 5, 6});
  EXPECT_EQ(warnings(finite), std::vector<std::string>{});
}

TEST(document_rules, deep_nesting_is_refused_before_anything_recurses) {
  EXPECT_EQ(import_text(std::string(1'000'000, '[')), "json-depth at ");
  EXPECT_EQ(
      import_text(R"({"asset":{"version":"2.0"},"extras":)" + std::string(300, '[') + std::string(300, ']') + "}"),
      "json-depth at ");
  EXPECT_EQ(import_text(R"({"asset":{"version":"2.0"},"extras":")" + std::string(300, '[') + "\"}"), "ok")
      << "brackets in a string";
}

TEST(document_rules, versions_other_than_2_are_refused) {
  EXPECT_EQ(import_text(R"({"asset":{"version":"1.0"}})"), "asset-version at /asset/version");
  EXPECT_EQ(import_text(R"({"asset":{"version":1.0},"nodes":{"a":{}},"scene":"b"})"),
            "asset-version at /asset/version");
  EXPECT_EQ(import_text(R"({"asset":{"version":1e300}})"), "asset-version at /asset/version");
  EXPECT_EQ(import_text(R"({"asset":{"version":2.0}})"), "json-type at /asset/version");
  EXPECT_EQ(import_text(R"({"asset":{"version":"two"}})"), "asset-version at /asset/version");
  EXPECT_EQ(import_text(R"({"asset":{"version":"2.0","minVersion":"2.1"}})"), "asset-version at /asset/minVersion");
  EXPECT_EQ(import_text(R"({"asset":{}})"), "json-missing at /asset");
  EXPECT_TRUE(
      warns(import_gltf(bytes_of(R"({"asset":{"version":"2.1"}})"), "x"), "asset-minor-version", "/asset/version"));
}

TEST(document_rules, G57_required_extensions_are_refused_by_name) {
  const auto result = import_gltf(
      bytes_of(R"({"asset":{"version":"2.0"},"extensionsUsed":["VENDOR_x"],"extensionsRequired":["VENDOR_x"]})"), "x");
  EXPECT_EQ(outcome(result), "extension-required at /extensionsRequired/0");
  EXPECT_NE(result.error().issue.detail.find("VENDOR_x"), std::string::npos);
  EXPECT_EQ(import_json(R"("extensionsUsed":["VENDOR_x"])"), "ok");
  EXPECT_EQ(import_json(R"("extensionsRequired":["KHR_mesh_quantization"])"), "ok");
}

TEST(document_rules, T1_types_and_required_properties_are_checked_with_their_place) {
  EXPECT_EQ(import_json(R"("nodes":{})"), "json-type at /nodes");
  EXPECT_EQ(import_json(R"("nodes":[1])"), "json-type at /nodes/0");
  EXPECT_EQ(import_json(R"("nodes":[{"mesh":-1}])"), "json-type at /nodes/0/mesh");
  EXPECT_EQ(import_json(R"("nodes":[{"mesh":"0"}])"), "json-type at /nodes/0/mesh");
  EXPECT_EQ(import_json(R"("nodes":[{"mesh":4294967296}])"), "json-type at /nodes/0/mesh");
  EXPECT_EQ(import_json(R"("nodes":[{"children":[0.5]}])"), "json-type at /nodes/0/children/0");
  EXPECT_EQ(import_json(R"("nodes":[{"rotation":[0,0,1]}])"), "json-type at /nodes/0/rotation");
  EXPECT_EQ(import_json(R"("nodes":[{"scale":[1,1,1e39]}])"), "json-type at /nodes/0/scale/2");
  EXPECT_EQ(import_json(R"("nodes":[{"matrix":[1,0,0]}])"), "json-type at /nodes/0/matrix");
  EXPECT_EQ(import_json(R"("meshes":[{"primitives":[{"attributes":{"a/b~c":"x"}}]}])"),
            "json-type at /meshes/0/primitives/0/attributes/a~1b~0c");
  EXPECT_EQ(import_json(R"("accessors":[{"componentType":5124,"count":1,"type":"SCALAR"}])"),
            "json-type at /accessors/0/componentType");
  EXPECT_EQ(import_json(R"("accessors":[{"componentType":5126,"count":1,"type":"VEC5"}])"),
            "json-type at /accessors/0/type");
  EXPECT_EQ(import_json(R"("accessors":[{"componentType":5126,"type":"VEC3"}])"), "json-missing at /accessors/0");
  EXPECT_EQ(import_json(R"("accessors":[{"componentType":5126,"count":1e16,"type":"VEC3"}])"),
            "json-type at /accessors/0/count");
  EXPECT_EQ(survived_json(R"("animations":[{"channels":[{"sampler":0}],"samplers":[]}])"),
            "json-missing at /animations/0/channels/0");
}

TEST(document_rules, integers_may_be_written_with_a_zero_fraction) {
  EXPECT_EQ(import_json(R"("nodes":[{"children":[1.0]},{}],"scenes":[{"nodes":[0.0]}],"scene":0.0)"), "ok");
}

TEST(document_rules, empty_arrays_are_taken_as_absent) {
  EXPECT_TRUE(warns(import_gltf(bytes_of(R"({"asset":{"version":"2.0"},"nodes":[]})"), "x"), "empty-array", "/nodes"));
}

TEST(document_rules, T1_every_index_is_checked) {
  EXPECT_EQ(import_json(R"("nodes":[{"mesh":0}])"), "reference at /nodes/0/mesh");
  EXPECT_EQ(import_json(R"("nodes":[{"skin":0}])"), "reference at /nodes/0/skin");
  EXPECT_EQ(import_json(R"("nodes":[{"camera":0}])"), "reference at /nodes/0/camera");
  EXPECT_EQ(import_json(R"("nodes":[{"children":[7]}])"), "reference at /nodes/0/children/0");
  EXPECT_EQ(import_json(R"("nodes":[{}],"scenes":[{"nodes":[1]}])"), "reference at /scenes/0/nodes/0");
  EXPECT_EQ(import_json(R"("scene":0)"), "reference at /scene");
  EXPECT_EQ(import_json(R"("skins":[{"joints":[0]}])"), "reference at /skins/0/joints/0");
  EXPECT_EQ(import_json(R"("nodes":[{}],"skins":[{"joints":[0],"skeleton":3}])"), "reference at /skins/0/skeleton");
  EXPECT_EQ(import_json(R"("nodes":[{}],"skins":[{"joints":[0],"inverseBindMatrices":0}])"),
            "reference at /skins/0/inverseBindMatrices");
  EXPECT_EQ(import_json(R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}])"),
            "reference at /meshes/0/primitives/0/attributes/POSITION");
  EXPECT_EQ(import_json(R"("meshes":[{"primitives":[{"attributes":{},"indices":2}]}])"),
            "reference at /meshes/0/primitives/0/indices");
  EXPECT_EQ(import_json(R"("meshes":[{"primitives":[{"attributes":{},"material":2}]}])"),
            "reference at /meshes/0/primitives/0/material");
  EXPECT_EQ(import_json(R"("meshes":[{"primitives":[{"attributes":{},"targets":[{"POSITION":1}]}]}])"),
            "reference at /meshes/0/primitives/0/targets/0/POSITION");
  EXPECT_EQ(import_json(R"("bufferViews":[{"buffer":0,"byteLength":4}])"), "reference at /bufferViews/0/buffer");
  EXPECT_EQ(import_json(R"("accessors":[{"bufferView":0,"componentType":5126,"count":1,"type":"SCALAR"}])"),
            "reference at /accessors/0/bufferView");
  EXPECT_EQ(survived_json(R"("animations":[{"channels":[{"sampler":1,"target":{"path":"scale"}}],"samplers":[]}])"),
            "reference at /animations/0/channels/0/sampler");
  EXPECT_EQ(survived_json(R"("animations":[{"channels":[],"samplers":[{"input":0,"output":0}]}])"),
            "reference at /animations/0/samplers/0/input, reference at /animations/0/samplers/0/output");
  EXPECT_EQ(import_json(R"("materials":[{"normalTexture":{"index":0}}])"),
            "reference at /materials/0/normalTexture/index");
  EXPECT_EQ(import_json(R"("textures":[{"source":0}])"), "reference at /textures/0/source");
  EXPECT_EQ(import_json(R"("images":[{"bufferView":0}])"), "reference at /images/0/bufferView");
}

/// A document with two entries in each list. The second entry refers to the second entry of other lists.
const char* const kTwoOfEach = R"({"asset": {"version": "2.0"}, "scene": 1, "scenes": [{}, {"nodes": [0, 1]}],
  "nodes": [{}, {"mesh": 1, "skin": 1, "camera": 1, "children": [0]}],
  "meshes": [{"primitives": [{"attributes": {}}]}, {"primitives": [{"attributes": {}},
    {"attributes": {"POSITION": 1, "NORMAL": 1}, "indices": 1, "material": 1, "targets": [{}, {"POSITION": 1, "NORMAL": 1}]}]}],
  "skins": [{"joints": [0]}, {"joints": [0, 1], "skeleton": 1, "inverseBindMatrices": 1}],
  "animations": [{"samplers": [], "channels": []}, {"samplers": [{"input": 0, "output": 0}, {"input": 1, "output": 1}],
    "channels": [{"sampler": 0, "target": {"path": "scale"}}, {"sampler": 1, "target": {"node": 1, "path": "scale"}}]}],
  "materials": [{}, {"pbrMetallicRoughness": {"baseColorTexture": {"index": 1}, "metallicRoughnessTexture": {"index": 1}},
    "normalTexture": {"index": 1}, "occlusionTexture": {"index": 1}, "emissiveTexture": {"index": 1}}],
  "textures": [{}, {"source": 1, "sampler": 1}], "samplers": [{}, {}], "images": [{"uri": "a"}, {"bufferView": 1}],
  "cameras": [{"type": "perspective", "perspective": {"yfov": 1, "znear": 1}}, {"type": "perspective", "perspective": {"yfov": 1, "znear": 1}}],
  "accessors": [{"componentType": 5126, "count": 1, "type": "SCALAR"}, {"bufferView": 1, "componentType": 5126, "count": 1,
    "type": "SCALAR", "sparse": {"count": 1, "indices": {"bufferView": 1, "componentType": 5121}, "values": {"bufferView": 1}}}],
  "bufferViews": [{"buffer": 0, "byteLength": 4}, {"buffer": 1, "byteLength": 4}],
  "buffers": [{"byteLength": 4}, {"byteLength": 4}]})";

/// "pointer: detail" of every reference to an entry that does not exist.
std::vector<std::string> broken_references(const Json& document) {
  const std::string text = document.dump();
  const auto result = import_gltf(bytes_of(text), "x");
  std::vector<std::string> found;
  std::vector<ImportIssue> all = result ? result->warnings : std::vector{result.error().issue};
  if (!result) all.insert(all.end(), result.error().more_errors.begin(), result.error().more_errors.end());
  for (const ImportIssue& issue : all)
    if (issue.rule == "reference")
      found.push_back(issue.json_pointer + ": " + issue.detail.substr(0, issue.detail.find(';')));
  return found;
}

TEST(document_rules, T1_every_index_of_every_entry_is_less_than_the_length_of_its_list) {
  const Json document = Json::parse(kTwoOfEach);
  EXPECT_EQ(broken_references(document), std::vector<std::string>());
  std::size_t count = 0;
  const Json flat = document.flatten();
  for (const auto& [pointer, value] : flat.items()) {
    const std::string name = pointer.substr(pointer.rfind('/') + 1), list = pointer.substr(1, pointer.find('/', 1) - 1);
    const bool in_list = pointer.find("/nodes/") != std::string::npos ||
                         pointer.find("/children/") != std::string::npos ||
                         pointer.find("/joints/") != std::string::npos;
    const bool is_reference = value == 1 && (in_list || list == "scene" || list == "meshes" || list == "materials" ||
                                             list == "textures" || list == "images" || list == "skins" ||
                                             list == "animations" || name == "bufferView" || name == "buffer");
    if (!is_reference) continue;
    Json broken = document;
    broken[Json::json_pointer(pointer)] = 2;
    EXPECT_EQ(broken_references(broken), std::vector{pointer + ": index 2 of 2 entries"});
    ++count;
  }
  EXPECT_EQ(count, 30u);
}

TEST(document_rules, T9_no_number_as_the_index_of_a_primitive_leads_out_of_the_lists) {
  for (const char* number : {"1", "2147483647", "2147483648", "4294967294", "4294967295", "4294967296",
                             "18446744073709551615", "18446744073709551616", "-1", "-2147483648", "1e300", "0.5"})
    for (const char* property : {"indices", "material", "POSITION"}) {
      const std::string primitive = property == std::string("POSITION")
                                        ? R"("attributes":{"POSITION":)" + std::string(number) + "}"
                                        : R"("attributes":{},")" + std::string(property) + "\":" + number;
      const std::string place =
          "/meshes/0/primitives/0/" + std::string(property == std::string("POSITION") ? "attributes/" : "") + property;
      EXPECT_THAT(import_json(R"("meshes":[{"primitives":[{)" + primitive + "}]}]"),
                  testing::AnyOf("reference at " + place, "json-type at " + place))
          << number;
    }
}

TEST(document_rules, all_errors_of_a_step_are_reported_together) {
  const auto result = import_gltf(bytes_of(R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0},{"skin":0}]})"), "x");
  ASSERT_FALSE(result);
  ASSERT_EQ(result.error().more_errors.size(), 1u);
  EXPECT_EQ(result.error().more_errors[0].json_pointer, "/nodes/1/skin");
}

TEST(document_rules, a_later_step_reports_its_errors_only_if_all_are_collected) {
  const std::string shape = R"("nodes":[{"matrix":[1]}])", reference = R"("scenes":[{"nodes":[7]}])";
  const std::string text = R"({"asset":{"version":"2.0"},)" + shape + ',' + reference + '}';
  const auto first = import_gltf(bytes_of(text), "x");
  ASSERT_FALSE(first);
  EXPECT_TRUE(first.error().more_errors.empty());
  const auto all = import_gltf(bytes_of(text), "x", {.collect_all_errors = true});
  ASSERT_FALSE(all);
  EXPECT_EQ(all.error().issue.json_pointer, first.error().issue.json_pointer);
  ASSERT_EQ(all.error().more_errors.size(), 1u);
  EXPECT_EQ(all.error().more_errors[0].json_pointer, "/scenes/0/nodes/0");
}

TEST(document_rules, G55_the_nodes_are_a_forest) {
  EXPECT_EQ(import_json(R"("nodes":[{"children":[1]},{"children":[0]}])"), "node-cycle at /nodes/0");
  EXPECT_EQ(import_json(R"("nodes":[{"children":[0]}])"), "node-cycle at /nodes/0");
  EXPECT_EQ(import_json(R"("nodes":[{"children":[2]},{"children":[2]},{}])"), "node-parents at /nodes/1/children/0");
  EXPECT_EQ(import_json(R"("nodes":[{"children":[1,1]},{}])"), "node-parents at /nodes/0/children/1");
}

TEST(document_rules, G55_a_chain_of_100_000_nodes_loads) {
  constexpr int kCount = 100'000;
  std::string text = R"({"asset":{"version":"2.0"},"nodes":[)";
  for (int n = 0; n < kCount; ++n) text += n + 1 < kCount ? R"({"children":[)" + std::to_string(n + 1) + "]}," : "{}]}";
  const auto result = import_gltf(bytes_of(text), "x");
  ASSERT_EQ(outcome(result), "ok");
  EXPECT_EQ(result->scene.skeleton.joint_count(), static_cast<std::size_t>(kCount));
  EXPECT_EQ(result->scene.skeleton.level_begin.size(), static_cast<std::size_t>(kCount) + 1);
}

TEST(document_rules, G56_scenes_and_their_roots) {
  const auto none = import_gltf(bytes_of(R"({"asset":{"version":"2.0"},"nodes":[{}]})"), "x");
  ASSERT_TRUE(none);
  EXPECT_EQ(none->scene.default_scene, kNone);
  const auto first =
      import_gltf(bytes_of(R"({"asset":{"version":"2.0"},"nodes":[{}],"scenes":[{"nodes":[0]},{}]})"), "x");
  ASSERT_TRUE(first);
  EXPECT_EQ(first->scene.default_scene, 0u);
  const std::string inner = R"({"asset":{"version":"2.0"},"nodes":[{"children":[1]},{}],"scenes":[{"nodes":[1]}]})";
  EXPECT_TRUE(warns(import_gltf(bytes_of(inner), "x"), "scene-root", "/scenes/0/nodes/0"));
}

TEST(document_rules, G66_each_part_of_an_accessor_reads_its_buffer) {
  const auto missing = [](int base, int indices, int values) {
    Json file = Json::parse(R"({"asset": {"version": "2.0"},
      "buffers": [{"byteLength": 16, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAAAAAA=="},
        {"byteLength": 16}], "bufferViews": [{"buffer": 0, "byteLength": 4}, {"buffer": 1, "byteLength": 4}],
      "accessors": [{"componentType": 5126, "count": 1, "type": "SCALAR",
        "sparse": {"count": 1, "indices": {"componentType": 5121}, "values": {}}}]})");
    Json& accessor = file["accessors"][0];
    accessor["bufferView"] = base;
    accessor["sparse"]["indices"]["bufferView"] = indices;
    accessor["sparse"]["values"]["bufferView"] = values;
    return outcome(import_gltf(bytes_of(file.dump()), "x"));
  };
  EXPECT_EQ(missing(0, 0, 0), "ok");
  EXPECT_EQ(missing(1, 0, 0), "buffer-missing at /buffers/1");
  EXPECT_EQ(missing(0, 1, 0), "buffer-missing at /buffers/1");
  EXPECT_EQ(missing(0, 0, 1), "buffer-missing at /buffers/1");
}

TEST(document_rules, bounds_of_floats_are_compared_as_floats) {
  TinyGltf file;
  Json& primitive = file.add_triangle();
  const std::size_t position = file.vec3({0.1f, 0, 0, 1, 0.7f, 0, 0.5f, 0, 0.3f});
  primitive["attributes"]["POSITION"] = position;
  file.root["accessors"][position]["min"] = {0.1, 0, 0};
  file.root["accessors"][position]["max"] = {1, 0.7, 0.3};
  ImportOptions thorough;
  thorough.thorough = true;
  const auto result = file.import(thorough);
  ASSERT_EQ(outcome(result), "ok");
  for (const ImportIssue& warning : result->warnings) EXPECT_NE(warning.rule, "accessor-bounds") << warning.detail;
}

TEST(document_rules, a_sparse_accessor_without_replacements_is_its_base) {
  const auto result = import_gltf(bytes_of(R"({"asset": {"version": "2.0"},
      "buffers": [{"byteLength": 16, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAAAAAA=="}],
      "bufferViews": [{"buffer": 0, "byteLength": 16}],
      "accessors": [{"bufferView": 0, "componentType": 5126, "count": 1, "type": "SCALAR", "sparse": {"count": 0,
        "indices": {"bufferView": 0, "componentType": 5121}, "values": {"bufferView": 0}}}]})"),
                                  "x");
  EXPECT_EQ(outcome(result), "ok");
  EXPECT_TRUE(warns(result, "accessor-empty", "/accessors/0/sparse/count"));
}

TEST(document_rules, G66_a_missing_buffer_fails_only_who_reads_it) {
  const std::string unread = R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":4}]})";
  EXPECT_TRUE(warns(import_gltf(bytes_of(unread), "x"), "buffer-unread", "/buffers/0"));
  const char* read = R"("buffers":[{"byteLength":4}],"bufferViews":[{"buffer":0,"byteLength":4}],)"
                     R"("accessors":[{"bufferView":0,"componentType":5126,"count":1,"type":"SCALAR"}])";
  EXPECT_EQ(import_json(read), "buffer-missing at /buffers/0");
  EXPECT_EQ(import_json(R"("buffers":[{"byteLength":4,"uri":"data:;base64,YWI="}])"), "buffer-short at /buffers/0");
  EXPECT_EQ(
      import_json(
          R"("buffers":[{"byteLength":2,"uri":"data:;base64,YWI="}],"bufferViews":[{"buffer":0,"byteOffset":1,"byteLength":2}])"),
      "buffer-view-range at /bufferViews/0/byteLength");
}

TEST(document_rules, G66_a_missing_image_is_a_warning) {
  const std::string text =
      R"({"asset":{"version":"2.0"},"images":[{"uri":"data:image/png;base64,"},{"uri":"gone.png"}]})";
  const auto result = import_gltf(bytes_of(text), "x");
  EXPECT_TRUE(warns(result, "image-missing", "/images/0"));
  EXPECT_TRUE(warns(result, "uri-forbidden", "/images/1/uri")) << "a document in memory has no folder";
}

TEST(document_rules, T5_an_odd_stride_is_only_a_warning) {
  const std::string text = R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":2,"uri":"data:;base64,YWI="}],)"
                           R"("bufferViews":[{"buffer":0,"byteLength":2,"byteStride":255}]})";
  EXPECT_TRUE(warns(import_gltf(bytes_of(text), "x"), "buffer-view-stride", "/bufferViews/0/byteStride"));
}

TEST(document_rules, G68_counts_without_bytes_do_not_allocate) {
  const char* huge = R"("accessors":[{"componentType":5126,"count":2000000000,"type":"VEC3"}],)"
                     R"("meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}])";
  EXPECT_EQ(import_json(huge), "memory-budget at ");
  std::string shared = R"("accessors":[{"componentType":5126,"count":100000,"type":"VEC3"}],"meshes":[{"primitives":[)";
  for (int p = 0; p < 1000; ++p) shared += std::string(p ? "," : "") + R"({"attributes":{"POSITION":0}})";
  EXPECT_EQ(import_json((shared + "]}]").c_str()), "memory-budget at ") << "many users of one accessor";
}

TEST(document_rules, G68_depth_and_unpacked_bytes_are_bounded_by_options) {
  ImportOptions options;
  options.max_node_depth = 2;
  const std::string deep = R"({"asset":{"version":"2.0"},"nodes":[{"children":[1]},{"children":[2]},{}]})";
  EXPECT_EQ(outcome(import_gltf(bytes_of(deep), "x", options)), "too-many at /nodes");
  options.max_node_depth = 3;
  EXPECT_EQ(outcome(import_gltf(bytes_of(deep), "x", options)), "ok");
  TinyGltf file;
  file.add_triangle();
  file.root.erase("nodes");  // the node would count against the limit, too
  options.max_unpacked_bytes = 35;
  EXPECT_EQ(outcome(file.import(options)), "memory-budget at ") << "three positions take 36 bytes";
  options.max_unpacked_bytes = 36;
  EXPECT_EQ(outcome(file.import(options)), "ok");
}

TEST(document_rules, G68_lists_are_bounded) {
  ImportOptions options;
  options.max_nodes = 2;
  const std::string text = R"({"asset":{"version":"2.0"},"nodes":[{},{},{}]})";
  EXPECT_EQ(outcome(import_gltf(bytes_of(text), "x", options)), "too-many at /nodes");
  options.max_file_bytes = 10;
  EXPECT_EQ(outcome(import_gltf(bytes_of(text), "x", options)), "file-too-large at ");
}

TEST(document_rules, files_that_cannot_be_opened_are_an_error) {
  EXPECT_EQ(outcome(import_gltf(std::filesystem::path("/nonexistent/x.gltf"))), "file-unreadable at ");
  EXPECT_EQ(outcome(import_gltf(std::filesystem::temp_directory_path())), "file-unreadable at ") << "a folder";
}

TEST(document_rules, rules_have_unique_identifiers_and_a_sentence) {
  std::set<std::string_view> ids;
  for (const RuleText& rule : all_rules()) {
    EXPECT_TRUE(ids.insert(rule.id).second) << rule.id;
    EXPECT_TRUE(rule.sentence.ends_with('.')) << rule.id;
    EXPECT_EQ(rule.id.find_first_not_of("abcdefghijklmnopqrstuvwxyz-"), std::string_view::npos) << rule.id;
  }
}

TEST(document_rules, descriptions_hold_file_place_rule_and_detail) {
  EXPECT_EQ(describe("a.glb", {Severity::error, "reference", "/nodes/0/mesh", "index 3"}),
            "a.glb: /nodes/0/mesh: error: reference: index 3");
  EXPECT_EQ(describe("a.glb", {Severity::warning, "json-bom", "", "skipped"}), "a.glb: warning: json-bom: skipped");
}

}  // namespace
}  // namespace sinew::test
