// SPDX-License-Identifier: MIT
// Imports every file of the corpus: models load, and malformed files end in a message, never in a crash.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <set>

#include "tests/importer/tiny_gltf.h"
#include "tests/support/corpus.h"

namespace sinew::test {
namespace {
namespace fs = std::filesystem;

const std::vector<std::string> kExtensions{".gltf", ".glb"};

TEST(import_corpus, every_model_loads_or_requires_what_is_not_supported) {
  std::size_t loaded = 0;
  for (const fs::path& file : files_for_tests("models", kExtensions)) {
    const auto result = import_gltf(file);
    if (result) {
      ++loaded;
      EXPECT_EQ(check(result->scene), ErrorCode::ok) << file;
      for (const ImportIssue& issue : result->warnings)
        EXPECT_EQ(issue.severity, Severity::warning) << describe(file.string(), issue);
    } else {
      EXPECT_EQ(result.error().issue.rule, "extension-required") << describe(file.string(), result.error().issue);
    }
  }
  EXPECT_GT(loaded, 0u);
}

TEST(import_corpus, poses_do_not_depend_on_images_or_made_vectors) {
  ImportOptions bare;
  bare.decode_images = bare.make_normals = bare.make_tangents = false;
  for (const fs::path& file : files_for_tests("models", kExtensions)) {
    const auto full = import_gltf(file), lean = import_gltf(file, bare);
    ASSERT_EQ(full.has_value(), lean.has_value()) << file;
    if (!full) continue;
    EXPECT_EQ(full->scene.skeleton.rest, lean->scene.skeleton.rest) << file;
    EXPECT_EQ(full->scene.first_weight, lean->scene.first_weight) << file;
  }
}

/// The validator's codes for faults in data that the importer reads, and for faults that a thorough import names. Other
/// faults are left out: buffer view targets, naming, alignment for GPUs.
const std::set<std::string> kTouchesData{"ACCESSOR_TOO_LONG",
                                         "ACCESSOR_SMALL_BYTESTRIDE",
                                         "ACCESSOR_OFFSET_ALIGNMENT",
                                         "ACCESSOR_TOTAL_OFFSET_ALIGNMENT",
                                         "ACCESSOR_INDEX_OOB",
                                         "ACCESSOR_NORMALIZED_INVALID",
                                         "ACCESSOR_SPARSE_COUNT_OUT_OF_RANGE",
                                         "ACCESSOR_SPARSE_INDEX_OOB",
                                         "ACCESSOR_SPARSE_INDICES_NON_INCREASING",
                                         "ACCESSOR_INVALID_FLOAT",
                                         "BUFFER_VIEW_INVALID_BYTE_STRIDE",
                                         "BUFFER_VIEW_TOO_BIG_BYTE_STRIDE",
                                         "DUPLICATE_ELEMENTS",
                                         "MESH_PRIMITIVE_POSITION_ACCESSOR_WITHOUT_BOUNDS",
                                         "SKIN_SKELETON_INVALID",
                                         "TYPE_MISMATCH",
                                         "UNDECLARED_EXTENSION",
                                         "ACCESSOR_VECTOR3_NON_UNIT",
                                         "ACCESSOR_INVALID_SIGN",
                                         "ACCESSOR_WEIGHTS_NON_NORMALIZED",
                                         "ACCESSOR_JOINTS_INDEX_OOB",
                                         "ACCESSOR_INVALID_IBM",
                                         "ACCESSOR_MIN_MISMATCH",
                                         "ACCESSOR_MAX_MISMATCH",
                                         "ACCESSOR_ANIMATION_INPUT_NEGATIVE",
                                         "ACCESSOR_ANIMATION_INPUT_NON_INCREASING",
                                         "ACCESSOR_ANIMATION_SAMPLER_OUTPUT_NON_NORMALIZED_QUATERNION",
                                         "ANIMATION_DUPLICATE_TARGETS",
                                         "ANIMATION_SAMPLER_OUTPUT_ACCESSOR_INVALID_FORMAT",
                                         "ANIMATION_SAMPLER_OUTPUT_ACCESSOR_INVALID_COUNT",
                                         "ANIMATION_SAMPLER_INPUT_ACCESSOR_INVALID_FORMAT",
                                         "ANIMATION_SAMPLER_INPUT_ACCESSOR_WITHOUT_BOUNDS",
                                         "ANIMATION_CHANNEL_TARGET_NODE_WEIGHTS_NO_MORPHS",
                                         "ASSET_MIN_VERSION_GREATER_THAN_VERSION",
                                         "BUFFER_BYTE_LENGTH_MISMATCH",
                                         "BUFFER_VIEW_TOO_LONG",
                                         "GLB_INVALID_MAGIC",
                                         "GLB_INVALID_VERSION",
                                         "GLB_CHUNK_TOO_BIG",
                                         "GLB_CHUNK_LENGTH_UNALIGNED",
                                         "GLB_EMPTY_CHUNK",
                                         "GLB_DUPLICATE_CHUNK",
                                         "GLB_UNEXPECTED_BIN_CHUNK",
                                         "GLB_UNEXPECTED_FIRST_CHUNK",
                                         "GLB_UNEXPECTED_END_OF_CHUNK_DATA",
                                         "GLB_LENGTH_MISMATCH",
                                         "INVALID_INDEX",
                                         "INVALID_JSON",
                                         "INVALID_IBM_ACCESSOR_COUNT",
                                         "INVALID_URI",
                                         "MESH_PRIMITIVE_INDEXED_SEMANTIC_CONTINUITY",
                                         "MESH_PRIMITIVE_INVALID_ATTRIBUTE",
                                         "MESH_PRIMITIVE_UNEQUAL_ACCESSOR_COUNT",
                                         "MESH_PRIMITIVES_UNEQUAL_TARGETS_COUNT",
                                         "MESH_PRIMITIVE_ATTRIBUTES_ACCESSOR_INVALID_FORMAT",
                                         "MESH_PRIMITIVE_MORPH_TARGET_INVALID_ATTRIBUTE_COUNT",
                                         "MESH_PRIMITIVE_MORPH_TARGET_NO_BASE_ACCESSOR",
                                         "MESH_PRIMITIVE_JOINTS_WEIGHTS_MISMATCH",
                                         "MESH_PRIMITIVE_TOO_FEW_TEXCOORDS",
                                         "NODE_LOOP",
                                         "NODE_PARENT_OVERRIDE",
                                         "NODE_MATRIX_TRS",
                                         "NODE_WEIGHTS_INVALID",
                                         "NODE_SKIN_WITH_NON_SKINNED_MESH",
                                         "PATTERN_MISMATCH",
                                         "ROTATION_NON_UNIT",
                                         "SCENE_NON_ROOT_NODE",
                                         "SKIN_NO_COMMON_ROOT",
                                         "UNDEFINED_PROPERTY",
                                         "UNKNOWN_ASSET_MAJOR_VERSION",
                                         "UNRESOLVED_REFERENCE",
                                         "UNSATISFIED_DEPENDENCY",
                                         "VALUE_MULTIPLE_OF",
                                         "VALUE_NOT_IN_RANGE"};

struct Fault {
  std::string code, place;
};

/// Errors in a validator report that concern data. A fault of the whole document has an empty place, as in our reports.
std::vector<Fault> data_faults(const fs::path& report) {
  std::vector<Fault> faults;
  std::ifstream stream(report);
  const Json json = Json::parse(stream, nullptr, false);
  if (!json.is_object() || !json.contains("issues")) return faults;
  for (const Json& message : json["issues"].value("messages", Json::array()))
    if (message.value("severity", 9) == 0 && kTouchesData.contains(message.value("code", ""))) {
      const std::string place = message.value("pointer", "");
      faults.push_back({message["code"], place == "/" ? "" : place});
    }
  return faults;
}

bool is_below(const std::string& place, const std::string& above) { return place.starts_with(above + '/'); }

/// The list entry of a pointer: "/accessors/3" of "/accessors/3/sparse/count".
std::string entry_of(const std::string& place) {
  const auto second = place.find('/', 1);
  const auto third = second == place.npos ? second : place.find('/', second + 1);
  return place.substr(0, third);
}

/// An issue about the whole document answers faults of its own kind. The JSON of an unreadable container is not parsed.
/// Files that are not containers are parsed as text. A number that is too big for the parser has no location.
bool answers_for_the_document(const ImportIssue& issue, const std::string& code) {
  if (issue.rule.starts_with("glb-")) return code.starts_with("GLB_") || code == "INVALID_JSON";
  if (issue.rule == "json-syntax" && code == "VALUE_NOT_IN_RANGE")
    return issue.detail.find("too big") != issue.detail.npos;
  if (issue.rule == "json-syntax" || issue.rule == "not-gltf")
    return code == "INVALID_JSON" || code == "GLB_INVALID_MAGIC";
  if (issue.rule == "json-depth" || issue.rule == "json-bom") return code == "INVALID_JSON";
  if (issue.rule == "json-missing") return code == "UNDEFINED_PROPERTY";
  return issue.rule == "json-type" && code == "TYPE_MISMATCH";
}

/// True if our issue lies at the place of the fault, inside it or around it, because our error may refuse the whole
/// list entry. If two channels have the same target, either may be named. A node with two parents hides one of two
/// cycles.
bool answers(const ImportIssue& issue, const Fault& fault) {
  const std::string& ours = issue.json_pointer;
  if (ours.empty() || fault.place.empty()) return answers_for_the_document(issue, fault.code);
  if (ours == fault.place || is_below(fault.place, ours) || is_below(ours, fault.place)) return true;
  if (issue.severity == Severity::error && entry_of(ours) == entry_of(fault.place)) return true;
  if (fault.code == "ANIMATION_DUPLICATE_TARGETS")
    return issue.rule == "animation-duplicate" && entry_of(ours) == entry_of(fault.place);
  return fault.code == "NODE_LOOP" && issue.rule == "node-parents";
}

std::vector<ImportIssue> all_issues(ImportResult<ImportedFile> result) {
  if (result) return std::move(result->warnings);
  std::vector<ImportIssue> issues{std::move(result.error().issue)};
  issues.insert(issues.end(), result.error().more_errors.begin(), result.error().more_errors.end());
  issues.insert(issues.end(), result.error().warnings.begin(), result.error().warnings.end());
  return issues;
}

TEST(import_corpus, T1_malformed_files_are_answered_where_an_independent_validator_finds_them_bad) {
  ImportOptions thorough;
  thorough.thorough = thorough.collect_all_errors = true;
  std::size_t answered = 0;
  for (const fs::path& file : files_for_tests("malformed", kExtensions)) {
    SCOPED_TRACE(file.string());
    const auto issues = all_issues(import_gltf(file, thorough));  // the time limit of CTest ends an import that hangs
    for (const auto& issue : issues) {
      EXPECT_FALSE(issue.rule.empty() || issue.detail.empty());
      EXPECT_NE(issue.rule, "internal") << issue.detail;
      EXPECT_NE(issue.rule, "scene-check") << issue.detail;
    }
    for (const Fault& fault : data_faults(file.string() + ".report.json")) {
      const bool found =
          std::any_of(issues.begin(), issues.end(), [&](const ImportIssue& issue) { return answers(issue, fault); });
      EXPECT_TRUE(found) << fault.code << " at " << fault.place << " goes unnoticed";
      answered += found ? 1 : 0;
    }
  }
  EXPECT_GE(answered, 36u) << "those of tests/generated/faults.py";
}

/// Truncations and single changed bytes of every small file: each import must return a scene or a message.
TEST(import_corpus, U25_damaged_models_end_in_a_scene_or_a_message) {
  for (const fs::path& file : files_for_tests("models", {".glb"})) {
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
