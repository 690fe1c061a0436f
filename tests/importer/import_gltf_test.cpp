// SPDX-License-Identifier: MIT
#include "importer/import_gltf.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "importer/export_glb.h"
#include "samples/showcase/showcase.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/corpus.h"
#include "tests/support/scene_equality.h"

namespace sinew {
namespace {

namespace fs = std::filesystem;

/// The showcase as files of over a megabyte each: rigid, skinned and morphed meshes with animations.
class import_gltf_test : public testing::Test {
 protected:
  import_gltf_test() {
    fs::create_directories(folder_);
    for (const auto& scene : showcase::showcase()) {
      files_.push_back(folder_ / (std::to_string(files_.size()) + ".glb"));
      const auto written = export_glb(scene.scene, files_.back());
      EXPECT_TRUE(written);
    }
  }
  ~import_gltf_test() override { fs::remove_all(folder_); }

  fs::path folder_ = fs::temp_directory_path() / ("sinew_import_test_" + std::to_string(getpid()));
  std::vector<fs::path> files_;
};

TEST_F(import_gltf_test, T11_takes_less_memory_than_three_times_the_file_at_any_moment) {
  for (const fs::path& path : files_) {
    const test::PeakMemory peak;
    const auto file = import_gltf(path);
    ASSERT_TRUE(file);
    EXPECT_GT(peak.bytes(), fs::file_size(path)) << "the counter sees nothing";
    EXPECT_LT(peak.bytes(), 3 * fs::file_size(path)) << path;
  }
}

/// Bytes of JSON in a file. While the document is read, memory holds the text, its tree, and some kilobytes of text for
/// tinygltf.
std::size_t json_bytes(const fs::path& path) {
  if (path.extension() == ".gltf") return fs::file_size(path);
  std::ifstream stream(path, std::ios::binary);
  std::array<unsigned char, 16> header{};
  stream.read(reinterpret_cast<char*>(header.data()), header.size());
  return header[12] | std::size_t{header[13]} << 8 | std::size_t{header[14]} << 16 | std::size_t{header[15]} << 24;
}

bool is_packed(const ImportedFile& file) {
  const auto& used = file.facts.extensions_used;
  return std::any_of(used.begin(), used.end(), [](const std::string& name) {
    return name.ends_with("_compression") || name.ends_with("_quantization");
  });
}

TEST(import_corpus_memory, T11_uncompressed_models_take_less_than_three_times_the_file_and_the_tree_of_their_json) {
  constexpr std::size_t kFixed = std::size_t{32} << 10;
  ImportOptions options;
  options.decode_images = false;  // images stay compressed
  std::size_t compared = 0;
  for (const fs::path& path : test::files_for_tests("models", {".gltf", ".glb"})) {
    const test::PeakMemory peak;
    const auto file = import_gltf(path, options);
    const std::size_t most = peak.bytes();
    if (!file || is_packed(*file)) continue;
    ++compared;
    EXPECT_LT(most, 3 * file->facts.file_bytes + 3 * json_bytes(path) + kFixed)
        << path << ", " << file->facts.file_bytes << " bytes";
  }
  EXPECT_GT(compared, 0u);
}

TEST_F(import_gltf_test, G67_the_size_allowed_is_an_option_and_exact) {
  const std::uint64_t size = fs::file_size(files_[0]);
  ImportOptions options;
  options.max_file_bytes = size;
  const auto file = import_gltf(files_[0], options);
  ASSERT_TRUE(file);
  EXPECT_EQ(file->facts.file_bytes, size);
  options.max_file_bytes = size - 1;
  const auto refused = import_gltf(files_[0], options);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().issue.rule, "file-too-large");
}

TEST_F(import_gltf_test, gives_the_same_bits_for_any_number_of_threads) {
  for (const fs::path& path : files_) {
    const auto many = import_gltf(path);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const auto single = import_gltf(path);
    ASSERT_TRUE(many && single);
    test::expect_equal(many->scene, single->scene);
  }
}

TEST_F(import_gltf_test, reports_progress_on_the_calling_thread_rising_to_one) {
  std::vector<double> seen;
  std::vector<std::string> stages;
  bool elsewhere = false;
  ImportOptions options;
  options.progress = [&, caller = std::this_thread::get_id()](const char* stage, double done) {
    elsewhere = elsewhere || std::this_thread::get_id() != caller;
    seen.push_back(done);
    stages.emplace_back(stage);
  };
  ASSERT_TRUE(import_gltf(files_[1], options));
  EXPECT_FALSE(elsewhere);
  EXPECT_EQ(std::vector(seen.begin(), seen.begin() + 4), (std::vector<double>{0.0, 0.1, 0.3, 0.35}));
  stages.erase(std::unique(stages.begin(), stages.end()), stages.end());  // meshes report once each
  EXPECT_EQ(stages,
            (std::vector<std::string>{"parse", "buffers", "scene", "meshes", "clips", "images", "check", "done"}));
  EXPECT_TRUE(std::is_sorted(seen.begin(), seen.end())) << testing::PrintToString(seen);
  EXPECT_EQ(seen.back(), 1.0);
}

}  // namespace
}  // namespace sinew
