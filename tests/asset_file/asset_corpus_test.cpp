// SPDX-License-Identifier: MIT
// Every model as an asset file and back: every field, and the bits of its frames.
#include <gtest/gtest.h>

#include "importer/import_gltf.h"
#include "runtime/asset_file/read_assets.h"
#include "runtime/asset_file/write_asset_file.h"
#include "tests/asset_file/played_frames.h"
#include "tests/support/corpus.h"
#include "tests/support/scene_equality.h"

namespace sinew::test {
namespace {

namespace fs = std::filesystem;

/// The scene of a file in memory that is gone afterwards.
tl::expected<Scene, AssetFileError> written_and_read(const Scene& scene, const AssetFileOptions& options) {
  const std::vector<std::byte> file = write_asset_file(scene, options);
  const auto opened = AssetFile::open(file);
  if (!opened) return tl::unexpected(opened.error());
  if (const auto sums = opened->check_sums(); !sums) return tl::unexpected(sums.error());
  return read_scene(*opened);
}

TEST(asset_corpus, every_model_comes_back_with_every_field_and_plays_the_same_frames) {
  std::size_t models = 0;
  for (const char* folder : {"models", "retarget", "vrm"})
    for (const fs::path& path : files_for_tests(folder, {".gltf", ".glb", ".vrm", ".vrma"})) {
      SCOPED_TRACE(path);
      const auto file = import_gltf(path, {.decode_images = false, .keep_encoded_images = true});
      if (!file) continue;
      ++models;
      const Scene& scene = file->scene;
      const auto truth = written_and_read(scene, {.truth = true});
      ASSERT_TRUE(truth) << describe(truth.error());
      expect_equal(scene, *truth);
      const std::vector<std::uint64_t> frames = hashes_of_frames(scene);
      EXPECT_EQ(hashes_of_frames(*truth), frames);
      const auto packed = written_and_read(scene, {.zstd_level = 1});
      ASSERT_TRUE(packed) << describe(packed.error());
      EXPECT_EQ(hashes_of_frames(*packed), frames);
      if (testing::Test::HasFailure()) return;
    }
  EXPECT_GT(models, 10u);
}

}  // namespace
}  // namespace sinew::test
