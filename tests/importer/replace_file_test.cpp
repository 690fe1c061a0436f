// SPDX-License-Identifier: MIT
#include "importer/write/replace_file.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <deque>
#include <fstream>
#include <iterator>
#include <vector>

#include "importer/file/sandboxed_files.h"
#include "tests/support/file_text.h"

namespace sinew::test {
namespace {
namespace fs = std::filesystem;

std::size_t open_descriptors() {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator("/proc/self/fd"), fs::directory_iterator()));
}

std::optional<std::string> replace(const fs::path& path, const std::string& text) {
  return write::replace_file(path, std::as_bytes(std::span(text)));
}

class replace_file : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_); }
  void TearDown() override { fs::remove_all(folder_); }

  std::size_t files() const {
    return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
  }

  const fs::path folder_ = fs::temp_directory_path() / ("sinew-replace-" + std::to_string(::getpid()));
  const fs::path file_ = folder_ / "pose.json";
};

TEST_F(replace_file, writes_a_new_file_and_replaces_an_old_one) {
  EXPECT_EQ(replace(file_, "first"), std::nullopt);
  EXPECT_EQ(text_of_file(file_), "first");
  EXPECT_EQ(replace(file_, ""), std::nullopt);
  EXPECT_EQ(text_of_file(file_), "");
  EXPECT_EQ(replace(file_, "third"), std::nullopt);
  EXPECT_EQ(text_of_file(file_), "third");
  EXPECT_EQ(files(), 1u);
}

TEST_F(replace_file, keeps_links_and_writes_where_they_lead) {
  ASSERT_EQ(replace(folder_ / "real.json", "old"), std::nullopt);
  fs::create_symlink("real.json", file_);
  EXPECT_EQ(replace(file_, "new"), std::nullopt);
  EXPECT_TRUE(fs::is_symlink(file_));
  EXPECT_EQ(text_of_file(folder_ / "real.json"), "new");
}

TEST_F(replace_file, refuses_what_is_no_regular_file) {
  ASSERT_EQ(::mkfifo(file_.c_str(), 0600), 0);
  EXPECT_EQ(replace(file_, "x"), "exists and is not a regular file");
  EXPECT_TRUE(fs::is_fifo(file_));
  EXPECT_EQ(replace(folder_, "x"), "exists and is not a regular file");
  EXPECT_EQ(files(), 1u);
}

TEST_F(replace_file, a_file_of_the_temporary_name_belongs_to_another) {
  const fs::path other = file_.string() + "." + std::to_string(::getpid()) + ".tmp";
  std::ofstream(other) << "another's";
  EXPECT_NE(replace(file_, "x"), std::nullopt);
  EXPECT_EQ(text_of_file(other), "another's");
  EXPECT_FALSE(fs::exists(file_));
}

TEST_F(replace_file, a_full_disk_leaves_the_old_file_and_nothing_else) {
  ASSERT_EQ(replace(file_, "old"), std::nullopt);
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_FSIZE, &before), 0);
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{1000, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &small), 0);
  const auto why = replace(file_, std::string(100'000, 'x'));
  ASSERT_EQ(::setrlimit(RLIMIT_FSIZE, &before), 0);
  std::signal(SIGXFSZ, handler);
  EXPECT_NE(why, std::nullopt);
  EXPECT_EQ(text_of_file(file_), "old");
  EXPECT_EQ(files(), 1u);
}

TEST_F(replace_file, files_that_are_read_or_written_are_closed_again) {
  const std::size_t before = open_descriptors();
  ASSERT_EQ(replace(file_, "text"), std::nullopt);
  EXPECT_EQ(open_descriptors(), before);
  SandboxedFiles sandbox(folder_, 100);
  std::deque<std::vector<std::byte>> storage;
  ASSERT_TRUE(sandbox.read("pose.json", storage));
  EXPECT_FALSE(sandbox.read("missing.json", storage));
  EXPECT_EQ(open_descriptors(), before);
}

}  // namespace
}  // namespace sinew::test
