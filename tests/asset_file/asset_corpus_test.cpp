// SPDX-License-Identifier: MIT
// Writes every model as an asset file and reads it back. Compares every field and the bits of frames.
#include <gtest/gtest.h>

#include <span>
#include <vector>

#include "importer/import_gltf.h"
#include "runtime/animation/skeleton_signature.h"
#include "runtime/asset_file/read_assets.h"
#include "runtime/asset_file/read_pages.h"
#include "runtime/asset_file/write_asset_file.h"
#include "runtime/base/same_bits.h"
#include "runtime/lod/compile_skeleton_lod.h"
#include "runtime/paging/paged_clip.h"
#include "runtime/plan/run_plan.h"
#include "tests/asset_file/played_frames.h"
#include "tests/support/corpus.h"
#include "tests/support/scene_equality.h"

namespace sinew::test {
namespace {

namespace fs = std::filesystem;

/// Writes and reads a scene. The file is freed before the scene is used.
tl::expected<Scene, AssetFileError> written_and_read(const Scene& scene, const AssetFileOptions& options) {
  const std::vector<std::byte> file = write_asset_file(scene, options);
  const auto opened = AssetFile::open(file);
  if (!opened) return tl::unexpected(opened.error());
  if (const auto sums = opened->check_sums(); !sums) return tl::unexpected(sums.error());
  return read_scene(*opened);
}

/// Frames with a skeleton LOD from the packed pages of a file must have the bits of frames from whole clips.
void expect_pages_play(const Scene& scene, const std::vector<std::byte>& file, const CompiledSkeletonLod& level) {
  const AssetFile opened = *AssetFile::open(file);
  const auto tables = read_page_tables(opened);
  const auto heads = read_clips(opened, skeleton_signature(scene.skeleton), LongClips::first_keys);
  ASSERT_TRUE(tables && heads);
  Needs needs;
  needs.out.skeleton_lod = level.detail;
  const Plan plan = compile_plan(lend(scene), needs), of_heads = compile_plan(lend(scene), *heads, needs);
  FrameBuffer whole(plan), paged(of_heads);
  std::vector<std::byte> unpacked;
  for (std::uint32_t c = 0; c < tables->size() && c < 3; ++c) {
    const PageTable& table = (*tables)[c];
    if (table.page_count() == 0) continue;
    PagedClip clip((*heads)[c], table.page_s, table.page_count(), {.kept_joints = kept_joints(plan)});
    for (double t = 0.0; t < scene.clips[c].duration_s(); t += 0.17 * scene.clips[c].duration_s()) {
      clip.at(t);
      while (const auto page = clip.next_page()) {
        const auto stored =
            std::span(file).subspan(table.offsets[*page], table.offsets[*page + 1] - table.offsets[*page]);
        ASSERT_TRUE(clip.load_page(*page, unpack_page(stored, unpacked).value()));
      }
      const PageSample at = clip.at(t);
      const ClipLayer from_page{.clip = c, .time_s = at.time_s, .page = &at.page}, from_clip{.clip = c, .time_s = t};
      ASSERT_EQ(run_plan(of_heads, {.layers = {&from_page, 1}}, paged), ErrorCode::ok);
      ASSERT_EQ(run_plan(plan, {.layers = {&from_clip, 1}}, whole), ErrorCode::ok);
      EXPECT_FALSE(at.is_missing);
      EXPECT_TRUE(same_bits<Affine>(paged.result().model, whole.result().model)) << t;
      EXPECT_TRUE(same_bits<float>(paged.result().weights, whole.result().weights)) << t;
      EXPECT_TRUE(same_bits<float>(paged.result().properties, whole.result().properties)) << t;
    }
  }
}

TEST(asset_corpus, every_model_plays_packed_pages_in_every_level_of_detail) {
  std::size_t models = 0;
  for (const char* folder : {"models", "retarget", "vrm"})
    for (const fs::path& path : files_for_tests(folder, {".gltf", ".glb", ".vrm", ".vrma"})) {
      SCOPED_TRACE(path);
      const auto file = import_gltf(path, {.decode_images = false});
      if (!file) continue;
      ++models;
      const Scene& scene = file->scene;
      std::vector<CompiledSkeletonLod> levels;
      for (const double tolerance_m : {1e-4, 0.02}) levels.push_back(compile_skeleton_lod(scene, tolerance_m));
      const AssetFileOptions options{.skeleton_lods = levels, .page_s = 0.4, .zstd_level = 3};
      const auto read = written_and_read(scene, options);
      ASSERT_TRUE(read) << describe(read.error());
      EXPECT_EQ(hashes_of_frames(*read), hashes_of_frames(scene));
      const std::vector<std::byte> bytes = write_asset_file(scene, options);
      const auto stored = read_skeleton_lods(*AssetFile::open(bytes), scene.skeleton);
      ASSERT_TRUE(stored) << describe(stored.error());
      ASSERT_EQ(stored->size(), levels.size());
      for (std::size_t i = 0; i < levels.size(); ++i) {
        EXPECT_EQ((*stored)[i].detail.kept, levels[i].detail.kept);
        EXPECT_TRUE(same_bits<Transform>((*stored)[i].detail.held, levels[i].detail.held));
        expect_pages_play(scene, bytes, (*stored)[i]);
      }
      if (testing::Test::HasFailure()) return;
    }
  EXPECT_GT(models, 10u);
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
