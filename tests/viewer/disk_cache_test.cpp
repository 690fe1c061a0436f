// SPDX-License-Identifier: MIT
// The disk cache between runs: damaged or foreign files are ignored.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>

#include "runtime/base/same_bits.h"
#include "viewer/app/load_environment.h"
#include "viewer/device/disk_cache.h"
#include "viewer/light/rooms.h"
#include "viewer/light/split_sum.h"
#include "viewer/light/stored_environment.h"

namespace sinew::viewer {
namespace {

namespace fs = std::filesystem;

/// A temporary folder, removed by the destructor.
class Folder {
 public:
  Folder()
      : path_(fs::temp_directory_path() / (std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) +
                                           std::to_string(::getpid()))) {
    fs::remove_all(path_);
  }
  ~Folder() { fs::remove_all(path_); }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  const fs::path& path() const { return path_; }
  std::size_t count() const {
    return fs::exists(path_) ? static_cast<std::size_t>(std::distance(fs::directory_iterator(path_), {})) : 0;
  }

  /// Changes the bytes of a file.
  void edit(const std::string& name, const std::function<void(std::string&)>& change) const {
    std::ifstream in(path_ / name, std::ios::binary);
    std::string bytes(std::istreambuf_iterator<char>(in), {});
    change(bytes);
    std::ofstream(path_ / name, std::ios::binary) << bytes;
  }

 private:
  fs::path path_;
};

std::vector<std::byte> some_bytes() {
  std::vector<std::byte> bytes(1000);
  for (std::size_t i = 0; i < bytes.size(); ++i) bytes[i] = static_cast<std::byte>(i * 7);
  return bytes;
}

TEST(disk_cache, gives_back_what_was_stored_under_the_same_name_and_key) {
  const Folder folder;
  const DiskCache cache(folder.path() / "deeper");
  EXPECT_FALSE(cache.load("a", 1));
  cache.store("a", 1, some_bytes());
  EXPECT_EQ(cache.load("a", 1), some_bytes());
  EXPECT_FALSE(cache.load("a", 2)) << "another key";
  EXPECT_FALSE(cache.load("b", 1)) << "another name";
  cache.store("a", 2, {});
  EXPECT_EQ(cache.load("a", 2), std::vector<std::byte>()) << "replaced";
  EXPECT_EQ(std::distance(fs::directory_iterator(folder.path() / "deeper"), {}), 1) << "no unfinished file is left";
}

TEST(disk_cache, does_not_load_what_is_damaged_or_cut) {
  const Folder folder;
  const DiskCache cache(folder.path());
  for (const std::size_t at : {0u, 8u, 16u, 24u, 32u, 1031u}) {
    cache.store("a", 1, some_bytes());
    folder.edit("a", [&](std::string& bytes) { bytes[at] = static_cast<char>(bytes[at] ^ 1); });
    EXPECT_FALSE(cache.load("a", 1)) << "byte " << at;
  }
  for (const std::size_t size : {0u, 31u, 32u, 1031u, 1033u}) {
    cache.store("a", 1, some_bytes());
    folder.edit("a", [&](std::string& bytes) { bytes.resize(size); });
    EXPECT_FALSE(cache.load("a", 1)) << size << " bytes";
  }
}

TEST(disk_cache, without_a_folder_or_where_none_can_be_is_empty) {
  EXPECT_FALSE(DiskCache().on());
  DiskCache().store("a", 1, some_bytes());
  EXPECT_FALSE(DiskCache().load("a", 1));
  const Folder folder;
  std::ofstream(folder.path()) << "a file";
  const DiskCache blocked(folder.path() / "inside");
  blocked.store("a", 1, some_bytes());
  EXPECT_FALSE(blocked.load("a", 1));
}

TEST(disk_cache, leaves_nothing_unfinished_where_a_file_cannot_take_its_place) {
  const Folder folder;
  fs::create_directories(folder.path() / "a" / "inside");
  const DiskCache cache(folder.path());
  cache.store("a", 1, some_bytes());
  EXPECT_FALSE(cache.load("a", 1));
  EXPECT_EQ(folder.count(), 1u);
  EXPECT_TRUE(fs::is_directory(folder.path() / "a" / "inside"));
}

void expect_same_light(const Environment& a, const Environment& b) {
  EXPECT_TRUE(same_bits(a.diffuse, b.diffuse));
  ASSERT_EQ(a.reflected.size(), b.reflected.size());
  for (std::size_t i = 0; i < a.reflected.size(); ++i)
    EXPECT_TRUE(same_bits(std::span(a.reflected[i].texels), std::span(b.reflected[i].texels))) << "level " << i;
}

TEST(stored_environment, has_the_bits_of_the_one_that_was_made) {
  const Folder folder;
  const DiskCache disk(folder.path());
  const auto made = load_environment("studio", disk).value(), loaded = load_environment("studio", disk).value();
  EXPECT_EQ(folder.count(), 1u);
  EXPECT_NE(made, loaded);
  expect_same_light(*made, *studio_environment());
  expect_same_light(*loaded, *studio_environment());
  EXPECT_TRUE(same_bits(std::span(loaded->split_sum), std::span(split_sum_table())));
}

TEST(stored_environment, is_made_again_where_the_file_is_of_another_sky_or_shape) {
  const Folder folder;
  const DiskCache disk(folder.path());
  CubeMap dark = sky_of(Room::studio);
  dark.texels[77].x *= 0.5f;
  EXPECT_NE(environment_key(dark), environment_key(sky_of(Room::studio)));
  disk.store("studio.light", environment_key(dark), stored_parts(*make_environment(dark)));
  expect_same_light(*load_environment("studio", disk).value(), *studio_environment());
  disk.store("studio.light", environment_key(sky_of(Room::studio)), some_bytes());
  expect_same_light(*load_environment("studio", disk).value(), *studio_environment());
}

/// Stored environments are identified by their sky and by kVersion of stored_environment.cpp. If these values change,
/// increase kVersion, or users keep the light of older versions.
TEST(stored_environment, is_of_the_version_that_these_values_belong_to) {
  const auto studio = studio_environment();
  EXPECT_NEAR(studio->diffuse[0].x, 0.601604f, 1e-5f);
  EXPECT_NEAR(studio->diffuse[6].z, 0.125804f, 1e-5f);
  EXPECT_NEAR(studio->reflected[2].texels[1500].y, 0.625471f, 1e-4f);
  EXPECT_NEAR(studio->reflected[5].texels[40].x, 0.586676f, 1e-4f);
  EXPECT_NEAR(split_sum_table()[2000].x, 0.757358f, 1e-5f);
}

TEST(disk_cache, is_stored_by_a_program_without_standard_input) {
  const Folder folder;
  const int input = ::dup(0);
  ::close(0);  // the next file that is opened has its number
  DiskCache(folder.path()).store("kept", 1, {});
  if (input >= 0) {
    ::dup2(input, 0);
    ::close(input);
  }
  EXPECT_EQ(folder.count(), 1u);
}

}  // namespace
}  // namespace sinew::viewer
