// SPDX-License-Identifier: MIT
// Files and buffers beyond 2 and 4 GiB. The files are sparse, so only pages that are read take memory.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/mman.h>
#include <unistd.h>

#include <fstream>

#include "importer/file/load_buffers.h"
#include "importer/read/accessor.h"
#include "importer/read/check_accessors.h"
#include "tests/importer/tiny_gltf.h"
#include "tests/support/allocation_counter.h"

namespace sinew::test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;

constexpr std::uint64_t kGiB = std::uint64_t{1} << 30;
constexpr std::uint64_t kSmall = std::uint64_t{1} << 20;  ///< memory limit of an import that makes no large copy

/// A file of zeros in its own folder; a test writes bytes at chosen places.
class SparseFile {
 public:
  SparseFile(const char* name, std::uint64_t size)
      : folder_(fs::temp_directory_path() / ("sinew-large-" + std::to_string(::getpid()))),
        path_(folder_ / name),
        size_(size) {
    fs::create_directories(folder_);
    descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
    EXPECT_EQ(::ftruncate(descriptor_, static_cast<off_t>(size)), 0);
  }
  ~SparseFile() {
    if (mapped_ != MAP_FAILED) ::munmap(mapped_, size_);
    ::close(descriptor_);
    fs::remove_all(folder_);
  }
  SparseFile(const SparseFile&) = delete;
  SparseFile& operator=(const SparseFile&) = delete;

  void write(std::uint64_t offset, std::span<const std::byte> bytes) {
    EXPECT_EQ(::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset)),
              static_cast<ssize_t>(bytes.size()));
  }
  void write(std::uint64_t offset, const std::string& text) { write(offset, bytes_of(text)); }
  template <class T>
  void write_values(std::uint64_t offset, const std::vector<T>& values) {
    write(offset, std::as_bytes(std::span(values)));
  }

  std::span<const std::byte> bytes() {
    if (mapped_ == MAP_FAILED) mapped_ = ::mmap(nullptr, size_, PROT_READ, MAP_PRIVATE | MAP_NORESERVE, descriptor_, 0);
    EXPECT_NE(mapped_, MAP_FAILED);
    return {static_cast<const std::byte*>(mapped_), mapped_ == MAP_FAILED ? 0 : size_};
  }
  const fs::path& path() const { return path_; }
  const fs::path& folder() const { return folder_; }

 private:
  fs::path folder_, path_;
  std::uint64_t size_;
  int descriptor_ = -1;
  void* mapped_ = MAP_FAILED;
};

std::string u32(std::uint64_t value) {
  std::string text;
  for (int shift = 0; shift < 32; shift += 8) text += static_cast<char>(value >> shift & 255);
  return text;
}

TEST(large_files, G67_a_glb_as_large_as_its_lengths_allow_is_read_on_both_sides_of_2_GiB) {
  constexpr std::uint64_t kFile = 4 * kGiB - 4, kJson = 1024, kBin = kFile - 12 - 8 - kJson - 8;
  constexpr std::uint64_t kPositions = 2 * kGiB + 8, kIndices = kBin - 8;
  Json root = Json::parse(R"({"asset":{"version":"2.0"},"nodes":[{"mesh":0}],)"
                          R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}]})");
  root["buffers"] = {{{"byteLength", kBin}}};
  root["bufferViews"] = {{{"buffer", 0}, {"byteOffset", kPositions}, {"byteLength", 36}},
                         {{"buffer", 0}, {"byteOffset", 4}, {"byteLength", kBin - 4}}};
  root["accessors"] = {
      {{"bufferView", 0},
       {"componentType", 5126},
       {"count", 3},
       {"type", "VEC3"},
       {"min", {0, 0, 0}},
       {"max", {2, 3, 0}}},
      {{"bufferView", 1}, {"byteOffset", kIndices - 4}, {"componentType", 5123}, {"count", 3}, {"type", "SCALAR"}}};
  std::string json = root.dump();
  json.resize(kJson, ' ');

  SparseFile file("x.glb", kFile);
  file.write(0, "glTF" + u32(2) + u32(kFile) + u32(kJson) + "JSON" + json + u32(kBin) + std::string("BIN\0", 4));
  const std::uint64_t bin = 12 + 8 + kJson + 8;
  file.write_values(bin + kPositions, std::vector<float>{0, 0, 0, 2, 0, 0, 0, 3, 0});
  file.write_values(bin + kIndices, std::vector<std::uint16_t>{0, 1, 2});

  const std::span<const std::byte> bytes = file.bytes();
  const PeakMemory peak;
  const auto result = import_gltf(bytes, "x.glb");
  ASSERT_EQ(outcome(result), "ok");
  EXPECT_LT(peak.bytes(), kSmall);
  EXPECT_EQ(result->facts.file_bytes, kFile);
  const Primitive& primitive = result->scene.meshes[0].primitives[0];
  EXPECT_THAT(primitive.positions, ElementsAre(glm::vec3(0), glm::vec3(2, 0, 0), glm::vec3(0, 3, 0)));
  EXPECT_THAT(primitive.indices, ElementsAre(0u, 1u, 2u));
}

/// A buffer of 5 GiB with numbers at 4 GiB + 16. Other numbers lie where 32-bit offsets would read.
class buffer_of_5_GiB : public testing::Test {
 protected:
  static constexpr std::uint64_t kSize = 5 * kGiB, kPlace = 4 * kGiB + 16;

  buffer_of_5_GiB() {
    file_.write_values(kPlace, std::vector<float>{1, 2, 3});
    file_.write_values(kPlace % (4 * kGiB), std::vector<float>{-1, -2, -3});
    document_.buffers.emplace_back().byte_length = kSize;
  }

  void add(std::uint64_t view_offset, std::uint64_t view_length, std::uint64_t accessor_offset) {
    gltf::BufferView& view = document_.buffer_views.emplace_back();
    view.buffer = 0;
    view.byte_offset = view_offset;
    view.byte_length = view_length;
    gltf::Accessor& accessor = document_.accessors.emplace_back();
    accessor.buffer_view = static_cast<std::uint32_t>(document_.buffer_views.size() - 1);
    accessor.byte_offset = accessor_offset;
    accessor.count = 3;
  }

  std::string loaded() {
    IssueLog log;
    SandboxedFiles files(std::nullopt, kSize);
    load_buffers(document_, files, file_.bytes(), log);
    point_views(document_, log);
    if (log.ok()) check_accessor_layout(document_, log);
    if (log.ok()) check_accessors(document_, log);
    return log.ok() ? "ok" : log.take_error("x").issue.rule;
  }

  SparseFile file_{"x.bin", kSize};
  gltf::Document document_;
};

TEST_F(buffer_of_5_GiB, G67_views_and_accessors_reach_past_4_GiB) {
  add(kPlace, 12, 0);
  add(0, kSize, kPlace);
  add(16, kSize - 16, 4 * kGiB);
  const PeakMemory peak;
  ASSERT_EQ(loaded(), "ok");
  for (std::uint32_t accessor = 0; accessor < 3; ++accessor)
    EXPECT_THAT(read_floats(document_, accessor), ElementsAre(1, 2, 3)) << accessor;
  EXPECT_LT(peak.bytes(), kSmall);
}

TEST_F(buffer_of_5_GiB, G67_what_reaches_past_its_end_is_refused) {
  add(kPlace, kSize - kPlace + 1, 0);
  EXPECT_EQ(loaded(), "buffer-view-range");
  document_ = {};
  document_.buffers.emplace_back().byte_length = kSize;
  add(kPlace, 4 * kGiB, 0);
  EXPECT_EQ(loaded(), "buffer-view-range");
  document_ = {};
  document_.buffers.emplace_back().byte_length = kSize;
  add(0, kSize, kSize - 8);
  EXPECT_EQ(loaded(), "accessor-fit");
  document_ = {};
  document_.buffers.emplace_back().byte_length = kSize + 1;
  EXPECT_EQ(loaded(), "buffer-short");
}

TEST(large_files, G67_files_past_the_allowance_are_refused_before_they_take_memory) {
  const SparseFile buffer("large.bin", 5 * kGiB);  // modulo 4 GiB it would fit
  std::ofstream(buffer.folder() / "x.gltf")
      << R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":12,"uri":"large.bin"}]})";
  ImportOptions options;
  options.max_file_bytes = 2 * kGiB;
  for (const ImportOptions& allowed : {options, ImportOptions{}}) {
    const PeakMemory peak;
    EXPECT_EQ(outcome(import_gltf(buffer.folder() / "x.gltf", allowed)), "file-too-large at /buffers/0/uri");
    EXPECT_EQ(outcome(import_gltf(buffer.path(), allowed)), "file-too-large at ");
    EXPECT_LT(peak.bytes(), kSmall);
  }
}

}  // namespace
}  // namespace sinew::test
