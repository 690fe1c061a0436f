// SPDX-License-Identifier: MIT
// Every file of the corpus: models load, malformed files end in a message, never in a crash.
#include <gtest/gtest.h>

#include <fstream>
#include <set>

#include "tests/importer/tiny_gltf.h"
#include "tests/support/corpus.h"

namespace sinew::test {
namespace {
namespace fs = std::filesystem;

const std::vector<std::string> kExtensions{".gltf", ".glb"};

TEST(import_corpus, every_model_loads_or_requires_what_is_not_supported) {
  if (!corpus()) GTEST_SKIP() << kNoCorpus;
  std::size_t loaded = 0;
  for (const fs::path& file : corpus_files("models", kExtensions)) {
    const auto result = import_gltf(file);
    if (result) {
      ++loaded;
      EXPECT_EQ(check(result->scene), ErrorCode::ok) << file;
      for (const ImportIssue& issue : result->warnings) EXPECT_EQ(issue.severity, Severity::warning) << describe(file.string(), issue);
    } else {
      EXPECT_EQ(result.error().issue.rule, "extension-required") << describe(file.string(), result.error().issue);
    }
  }
  EXPECT_GT(loaded, 0u);
}

TEST(import_corpus, poses_do_not_depend_on_images_or_made_vectors) {
  if (!corpus()) GTEST_SKIP() << kNoCorpus;
  ImportOptions bare;
  bare.decode_images = bare.make_normals = bare.make_tangents = false;
  for (const fs::path& file : corpus_files("models", kExtensions)) {
    const auto full = import_gltf(file), lean = import_gltf(file, bare);
    ASSERT_EQ(full.has_value(), lean.has_value()) << file;
    if (!full) continue;
    EXPECT_EQ(full->scene.skeleton.rest, lean->scene.skeleton.rest) << file;
    EXPECT_EQ(full->scene.first_weight, lean->scene.first_weight) << file;
  }
}

/// Codes of common validators for faults in data that the importer reads. Faults in what it does not read (bounds it
/// takes from the data, buffer view targets, naming) are not among them.
const std::set<std::string> kTouchesData{
    "ACCESSOR_TOO_LONG", "ACCESSOR_SMALL_BYTESTRIDE", "ACCESSOR_OFFSET_ALIGNMENT", "ACCESSOR_INDEX_OOB", "ACCESSOR_SPARSE_COUNT_OUT_OF_RANGE",
    "ACCESSOR_SPARSE_INDEX_OOB", "ACCESSOR_SPARSE_INDICES_NON_INCREASING", "ACCESSOR_INVALID_FLOAT", "ACCESSOR_VECTOR3_NON_UNIT",
    "ACCESSOR_INVALID_SIGN", "ACCESSOR_WEIGHTS_NON_NORMALIZED", "ACCESSOR_JOINTS_INDEX_OOB", "ACCESSOR_INVALID_IBM",
    "ACCESSOR_ANIMATION_INPUT_NEGATIVE", "ACCESSOR_ANIMATION_INPUT_NON_INCREASING", "ACCESSOR_ANIMATION_SAMPLER_OUTPUT_NON_NORMALIZED_QUATERNION",
    "ANIMATION_DUPLICATE_TARGETS", "ANIMATION_SAMPLER_OUTPUT_ACCESSOR_INVALID_FORMAT", "ANIMATION_SAMPLER_OUTPUT_ACCESSOR_INVALID_COUNT",
    "ANIMATION_SAMPLER_INPUT_ACCESSOR_INVALID_FORMAT", "ANIMATION_CHANNEL_TARGET_NODE_WEIGHTS_NO_MORPHS", "ASSET_MIN_VERSION_GREATER_THAN_VERSION",
    "BUFFER_BYTE_LENGTH_MISMATCH", "BUFFER_VIEW_TOO_LONG", "GLB_INVALID_MAGIC", "GLB_INVALID_VERSION", "GLB_CHUNK_TOO_BIG", "GLB_EMPTY_CHUNK",
    "GLB_DUPLICATE_CHUNK", "GLB_UNEXPECTED_BIN_CHUNK", "GLB_UNEXPECTED_FIRST_CHUNK", "GLB_UNEXPECTED_END_OF_CHUNK_DATA", "GLB_LENGTH_MISMATCH",
    "INVALID_JSON", "INVALID_IBM_ACCESSOR_COUNT", "INVALID_URI", "MESH_PRIMITIVE_UNEQUAL_ACCESSOR_COUNT", "MESH_PRIMITIVES_UNEQUAL_TARGETS_COUNT",
    "MESH_PRIMITIVE_ATTRIBUTES_ACCESSOR_INVALID_FORMAT", "MESH_PRIMITIVE_MORPH_TARGET_INVALID_ATTRIBUTE_COUNT",
    "MESH_PRIMITIVE_MORPH_TARGET_NO_BASE_ACCESSOR", "MESH_PRIMITIVE_JOINTS_WEIGHTS_MISMATCH", "NODE_LOOP", "NODE_PARENT_OVERRIDE",
    "NODE_MATRIX_TRS", "NODE_WEIGHTS_INVALID", "NODE_SKIN_WITH_NON_SKINNED_MESH", "ROTATION_NON_UNIT", "UNDEFINED_PROPERTY", "UNRESOLVED_REFERENCE"};

std::vector<std::string> data_faults(const fs::path& report) {
  std::vector<std::string> codes;
  std::ifstream stream(report);
  const Json json = Json::parse(stream, nullptr, false);
  if (!json.is_object() || !json.contains("issues")) return codes;
  for (const Json& message : json["issues"].value("messages", Json::array()))
    if (message.value("severity", 9) == 0 && kTouchesData.contains(message.value("code", ""))) codes.push_back(message["code"]);
  return codes;
}

TEST(import_corpus, malformed_files_end_in_a_scene_or_a_message) {
  if (!corpus()) GTEST_SKIP() << kNoCorpus;
  for (const fs::path& file : corpus_files("malformed", kExtensions)) {
    SCOPED_TRACE(file.string());
    const auto result = import_gltf(file);
    if (!result) {
      EXPECT_FALSE(result.error().issue.rule.empty());
      EXPECT_FALSE(result.error().issue.detail.empty());
      EXPECT_NE(result.error().issue.rule, "internal") << result.error().issue.detail;
      EXPECT_NE(result.error().issue.rule, "scene-check") << result.error().issue.detail;
    }
    const auto faults = data_faults(file.string() + ".report.json");
    EXPECT_TRUE(faults.empty() || !result || !result->warnings.empty()) << faults.front() << " goes unnoticed";
  }
}

/// Truncations and single changed bytes of every small file: an answer each time.
TEST(import_corpus, U25_damaged_models_end_in_a_scene_or_a_message) {
  if (!corpus()) GTEST_SKIP() << kNoCorpus;
  for (const fs::path& file : corpus_files("models", {".glb"})) {
    if (fs::file_size(file) > 5000) continue;
    std::ifstream stream(file, std::ios::binary);
    const std::string whole{std::istreambuf_iterator<char>(stream), {}};
    for (std::size_t at = 0; at < whole.size(); at += 7) {
      std::string damaged = whole;
      damaged[at] = static_cast<char>(damaged[at] ^ 0x55);
      const auto changed = import_gltf(bytes_of(damaged), "damaged.glb");
      const auto cut = import_gltf(bytes_of(whole).first(at), "cut.glb");
      EXPECT_FALSE(cut) << file << " cut at " << at;
      EXPECT_TRUE(changed || changed.error().issue.rule != "scene-check") << file << " changed at " << at;
    }
  }
}

}  // namespace
}  // namespace sinew::test
