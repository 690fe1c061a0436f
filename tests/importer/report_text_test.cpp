// SPDX-License-Identifier: MIT
// Texts of import reports: each names the place, explains the fault in words, appears once, and progress is reported.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include "tests/importer/tiny_draco.h"
#include "tests/importer/tiny_gltf.h"

namespace sinew::test {
namespace {
namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::vector<ImportIssue> issues_of(const ImportResult<ImportedFile>& result) {
  if (result) return result->warnings;
  std::vector<ImportIssue> all{result.error().issue};
  all.insert(all.end(), result.error().more_errors.begin(), result.error().more_errors.end());
  all.insert(all.end(), result.error().warnings.begin(), result.error().warnings.end());
  return all;
}

/// "rule at /pointer: detail" of every issue.
std::vector<std::string> said(const ImportResult<ImportedFile>& result) {
  std::vector<std::string> out;
  for (const ImportIssue& issue : issues_of(result))
    out.push_back(issue.rule + " at " + issue.json_pointer + ": " + issue.detail);
  return out;
}

/// True if the pointer names an existing value, or a missing property of an existing value.
bool is_place_of(const Json& document, const std::string& pointer) {
  const Json::json_pointer place(pointer);
  return document.contains(place) || document.contains(place.parent_pointer());
}

TEST(report_text, issues_of_every_broken_file_have_a_place_in_it_and_a_sentence) {
  ImportOptions thorough;
  thorough.thorough = thorough.collect_all_errors = true;
  std::size_t seen = 0;
  for (const auto& entry : fs::directory_iterator(fs::path(SINEW_SOURCE_DIR) / "tests" / "importer" / "broken")) {
    std::ifstream stream(entry.path());
    const Json document = Json::parse(stream);
    for (const ImportIssue& issue : issues_of(import_gltf(entry.path(), thorough))) {
      ++seen;
      ASSERT_TRUE(issue.json_pointer.empty() || issue.json_pointer.starts_with('/')) << entry.path() << issue.rule;
      EXPECT_TRUE(is_place_of(document, issue.json_pointer)) << entry.path() << issue.json_pointer;
      EXPECT_FALSE(issue.detail.empty() || issue.detail.starts_with('/')) << entry.path() << issue.detail;
    }
  }
  EXPECT_GT(seen, 100u);
}

/// An accessor of three scalars with a sparse replacement of the last one.
TinyGltf sparse_scalars() {
  TinyGltf file;
  const std::size_t base = file.scalars({1, 2, 3}), indices = file.add_view(std::vector<std::uint16_t>{2}),
                    values = file.add_view(std::vector<float>{7});
  file.root["accessors"][base]["sparse"] = {{"count", 1},
                                            {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
                                            {"values", {{"bufferView", values}}}};
  return file;
}

TEST(report_text, G24_a_sparse_part_that_does_not_fit_is_named) {
  EXPECT_THAT(said(sparse_scalars().import()), IsEmpty());
  for (const char* part : {"indices", "values"}) {
    TinyGltf file = sparse_scalars();
    file.root["accessors"][0]["sparse"][part]["byteOffset"] = 4;
    EXPECT_THAT(said(file.import()), ElementsAre("accessor-fit at /accessors/0/sparse/" + std::string(part) +
                                                 ": do not fit into their buffer view"));
  }
}

TEST(report_text, G68_many_accessors_may_not_share_a_long_sparse_list) {
  constexpr std::size_t kEach = std::size_t{1} << 20;
  TinyGltf file;
  const std::size_t zeros = file.add_view(std::vector<std::uint8_t>(kEach));
  const Json part{{"bufferView", zeros}, {"componentType", 5121}};
  for (int i = 0; i <= 256; ++i)
    file.root["accessors"].push_back({{"componentType", 5121},
                                      {"count", kEach},
                                      {"type", "SCALAR"},
                                      {"sparse", {{"count", kEach}, {"indices", part}, {"values", part}}}});
  ImportOptions all;
  all.collect_all_errors = true;
  for (const ImportOptions& options : {ImportOptions(), all}) {
    const auto result = file.import(options);
    ASSERT_FALSE(result) << "what follows is not checked";
    EXPECT_EQ(said(result)[0],
              "memory-budget at /accessors/256/sparse: more sparse replacements in all than the importer allows");
  }
}

TEST(report_text, instances_and_variants_without_their_lists_are_named_and_read_past) {
  TinyGltf instances;
  instances.add_triangle();
  instances.root["extensionsUsed"] = {"EXT_mesh_gpu_instancing"};
  for (const Json& extension : {Json::object(), Json{{"attributes", 5}}}) {
    instances.root["nodes"][0]["extensions"]["EXT_mesh_gpu_instancing"] = extension;
    const auto result = instances.import();
    EXPECT_THAT(said(result), ElementsAre("extension-value at /nodes/0/extensions/EXT_mesh_gpu_instancing: has no "
                                          "attributes; ignored"));
    EXPECT_EQ(result->scene.instances.size(), 1u);
  }
  TinyGltf variants;
  Json& primitive = variants.add_triangle();
  variants.root["extensionsUsed"] = {"KHR_materials_variants"};
  primitive["extensions"]["KHR_materials_variants"] = Json::object();
  variants.root["extensions"]["KHR_materials_variants"] = {{"variants", "red"}};
  EXPECT_THAT(said(variants.import()),
              testing::UnorderedElementsAre(
                  "extension-value at /extensions/KHR_materials_variants: has no array \"variants\"; ignored",
                  "extension-value at /meshes/0/primitives/0/extensions/KHR_materials_variants: has no array "
                  "\"mappings\"; ignored"));
}

TEST(report_text, G58_pointers_that_move_nothing_say_why) {
  const auto of_pointer = [](const std::string& text) {
    TinyGltf file;
    file.add_triangle();
    file.root["materials"] = Json::array({Json::object()});
    file.root["extensionsUsed"] = {"KHR_animation_pointer"};
    file.animate("pointer", file.times({0, 1}), file.scalars({0, 1}));
    file.root["animations"][0]["channels"][0]["target"]["extensions"]["KHR_animation_pointer"]["pointer"] = text;
    file.root["animations"][0]["channels"][0]["target"].erase("node");
    const auto all = said(file.import());
    return all.size() == 1 ? all[0] : testing::PrintToString(all);
  };
  const std::string place = "animation-pointer at /animations/0/channels/0/target: \"";
  EXPECT_THAT(of_pointer("/scene"), HasSubstr("is not a pointer that the runtime animates"));
  EXPECT_THAT(of_pointer("/materials/0/alphaMode"), HasSubstr("is not a property that the runtime animates"));
  EXPECT_THAT(of_pointer("/materials/0/normalTexture/scale"), HasSubstr("is not defined in the file and has no"));
  EXPECT_THAT(of_pointer("/materials/1/alphaCutoff"), HasSubstr("points past the end"));
}

/// A triangle with one morph target that lifts each vertex by its index plus one.
TinyGltf morphed_triangle(Json** attributes) {
  TinyGltf file;
  Json& primitive = file.add_triangle();
  primitive["targets"] = Json::array({{{"POSITION", file.vec3({0, 0, 1, 0, 0, 2, 0, 0, 3})}}});
  *attributes = &primitive["targets"][0];
  return file;
}

TEST(report_text, G47_attributes_of_targets_that_gltf_does_not_define_change_nothing) {
  Json* attributes = nullptr;
  TinyGltf file = morphed_triangle(&attributes);
  (*attributes)["ZENITH"] = (*attributes)["_OWN"] = file.vec3({9, 9, 9, 9, 9, 9, 9, 9, 9});
  const auto result = file.import();
  EXPECT_THAT(said(result), ElementsAre("mesh-attribute-name at /meshes/0/primitives/0/targets/0/ZENITH: is no "
                                        "attribute that glTF defines; ignored"));
  EXPECT_THAT(result->scene.meshes[0].primitives[0].morphs.targets[0].positions.deltas,
              ElementsAre(glm::vec3(0, 0, 1), glm::vec3(0, 0, 2), glm::vec3(0, 0, 3)));
}

TEST(report_text, G47_a_target_with_another_number_of_vertices_is_one_error) {
  for (const std::size_t count : {std::size_t{2}, std::size_t{4}}) {
    Json* attributes = nullptr;
    TinyGltf file = morphed_triangle(&attributes);
    (*attributes)["POSITION"] = file.add(std::vector<std::uint8_t>(3 * count), "VEC3", 5121, 3);
    EXPECT_THAT(said(file.import()), ElementsAre("mesh-attribute-count at /meshes/0/primitives/0/targets/0/POSITION: " +
                                                 std::to_string(count) + " entries for 3 vertices"));
  }
}

TEST(report_text, G47_a_target_of_a_type_that_gltf_does_not_allow_is_not_read) {
  Json* attributes = nullptr;
  TinyGltf file = morphed_triangle(&attributes);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  (*attributes)["POSITION"] = file.vec4(std::vector<float>(12, nan));
  EXPECT_THAT(said(file.import()), ElementsAre("mesh-attribute-format at /meshes/0/primitives/0/targets/0/POSITION: "
                                               "has a type that glTF does not allow for this attribute"));
}

TEST(report_text, G24_a_sparse_target_adds_to_what_lies_under_it) {
  Json* attributes = nullptr;
  TinyGltf file = morphed_triangle(&attributes);
  const std::size_t indices = file.add_view(std::vector<std::uint16_t>{1}),
                    values = file.add_view(std::vector<float>{5, 5, 5});
  file.root["accessors"][(*attributes)["POSITION"].get<std::size_t>()]["sparse"] = {
      {"count", 1},
      {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
      {"values", {{"bufferView", values}}}};
  const auto result = file.import();
  EXPECT_THAT(said(result), IsEmpty());
  EXPECT_THAT(result->scene.meshes[0].primitives[0].morphs.targets[0].positions.deltas,
              ElementsAre(glm::vec3(0, 0, 1), glm::vec3(5, 5, 5), glm::vec3(0, 0, 3)));
}

TEST(report_text, G62_what_accessors_of_a_draco_stream_say_about_views_does_not_count) {
  TinyGltf file = draco_document({{"POSITION", {0, 0, 0, 1, 0, 0, 0, 1, 0}}, {"TEXCOORD_0", {0, 0, 1, 0, 0, 1}}});
  for (Json& accessor : file.root["accessors"]) {
    accessor["bufferView"] = 0;
    accessor["byteOffset"] = 99'999;
  }
  EXPECT_THAT(said(file.import()), IsEmpty());
}

TEST(report_text, G57_a_file_that_is_refused_at_a_step_goes_no_further) {
  const auto stages = [](const TinyGltf& file) {
    std::vector<std::string> out;
    ImportOptions options;
    options.progress = [&](const char* stage, double) { out.emplace_back(stage); };
    EXPECT_FALSE(file.import(options));
    return out;
  };
  TinyGltf wrong_version, unknown;
  wrong_version.root["asset"]["version"] = "3.0";
  EXPECT_THAT(stages(wrong_version), ElementsAre("parse"));
  unknown.root["extensionsRequired"] = {"ACME_everything"};
  EXPECT_THAT(stages(unknown), ElementsAre("parse"));
}

}  // namespace
}  // namespace sinew::test
