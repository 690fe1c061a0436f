// SPDX-License-Identifier: MIT
// Rewrites every model of the corpus. Document and scene must stay the same, and rewriting the result must give the
// same file.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "tests/importer/rewritten.h"
#include "tests/support/corpus.h"
#include "tests/support/scene_equality.h"

namespace sinew::test {
namespace {
namespace fs = std::filesystem;

std::vector<fs::path> all_models() {
  std::vector<fs::path> files;
  for (const char* folder : {"models", "vrm", "retarget"})
    for (const fs::path& file : files_for_tests(folder, {".gltf", ".glb", ".vrm", ".vrma"})) files.push_back(file);
  return files;
}

Json document_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  if (!text.starts_with("glTF")) return Json::parse(text);
  const auto bytes = bytes_of(text);
  return split_glb({bytes.begin(), bytes.end()}).json;
}

/// Removes from both documents the properties that decoding and embedding change.
void forget_what_changes(Json& before, Json& after) {
  for (Json* root : {&before, &after}) {
    *root = without_places(*root);
    for (const char* list : {"extensionsUsed", "extensionsRequired"}) {
      Json& names = (*root)[list];
      for (const char* codec : {"KHR_draco_mesh_compression", "EXT_meshopt_compression", "KHR_meshopt_compression"})
        for (std::size_t i = names.size(); i-- > 0;)
          if (names[i] == codec) names.erase(i);
      if (names.empty()) root->erase(list);
    }
    if (root->contains("accessors"))
      for (Json& accessor : (*root)["accessors"])
        for (const char* bound : {"min", "max"})  // bounds of decoded elements are floats, so printed digits may differ
          if (accessor.contains(bound))
            for (Json& number : accessor[bound]) number = number.get<float>();
    for (auto list = root->begin(); list != root->end();)
      list = list->is_array() && list->empty() ? root->erase(list) : std::next(list);
    if (root->contains("images"))
      for (Json& image : (*root)["images"])
        for (const char* name : {"uri", "bufferView", "mimeType", "name"}) image.erase(name);
  }
}

bool has_draco(const Json& root) { return root.dump().find("KHR_draco_mesh_compression") != std::string::npos; }

TEST(rewrite_corpus, every_model_keeps_its_document_its_scene_and_its_second_copy) {
  RewriteOptions options;
  options.drop = {"image-missing"};
  std::size_t carried = 0;
  for (const fs::path& path : all_models()) {
    SCOPED_TRACE(path.string());
    const auto file = import_gltf(path, carrying());
    if (!file) continue;  // import_corpus_test checks refusals
    const auto once = rewrite_gltf(*file, options);
    ASSERT_TRUE(once) << once.error().issue.detail;
    const auto again = import_gltf(once->file, "once.glb", carrying());
    ASSERT_TRUE(again) << again.error().issue.detail;
    expect_equal(file->scene, again->scene);
    const auto twice = rewrite_gltf(*again, options);
    ASSERT_TRUE(twice);
    EXPECT_TRUE(once->file == twice->file) << "the second copy differs";
    Json before = document_of(path), after = split_glb(once->file).json;
    if (!has_draco(before)) {
      forget_what_changes(before, after);
      EXPECT_EQ(Json::diff(before, after), Json::array());
    }
    ++carried;
  }
  EXPECT_GT(carried, 0u);
}

}  // namespace
}  // namespace sinew::test
