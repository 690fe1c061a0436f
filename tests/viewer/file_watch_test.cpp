// SPDX-License-Identifier: MIT
// When changed files are read again: decided from stamps and times that the test makes up, and stamps of real files.
#include "viewer/app/reload/file_watch.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <vector>

namespace sinew::viewer {
namespace {

namespace fs = std::filesystem;
using testing::Key;
using testing::UnorderedElementsAre;

FileStamps files(int written, std::uintmax_t bytes = 10) {
  return {{"/a.glb", {fs::file_time_type(std::chrono::seconds(written)), bytes}}};
}

/// A watch that looks four times a second and says which look asks for a read.
class Looks {
 public:
  explicit Looks(const FileStamps& read) { watch.was_read(read); }
  bool operator()(const FileStamps& seen) { return watch.look(now_s_ += FileWatch::kPeriod_s, seen); }

  FileWatch watch;

 private:
  double now_s_ = 0.0;
};

TEST(file_watch, looks_four_times_a_second) {
  FileWatch watch;
  EXPECT_TRUE(watch.due(100.0)) << "at once";
  watch.look(100.0, files(1));
  EXPECT_FALSE(watch.due(100.2));
  EXPECT_TRUE(watch.due(100.25));
}

TEST(file_watch, reads_nothing_while_nothing_changes) {
  Looks look(files(1));
  for (int i = 0; i < 5; ++i) EXPECT_FALSE(look(files(1))) << i;
}

TEST(file_watch, reads_a_change_when_two_looks_see_the_same) {
  for (const FileStamps& changed : {files(2), files(1, 11), files(0), FileStamps()}) {
    Looks look(files(1));
    EXPECT_FALSE(look(changed)) << "it may still be written";
    EXPECT_TRUE(look(changed));
  }
}

TEST(file_watch, waits_while_a_file_is_written) {
  Looks look(files(1));
  for (int i = 2; i < 20; ++i) EXPECT_FALSE(look(files(1, 10u * static_cast<unsigned>(i)))) << "it grows";
  EXPECT_TRUE(look(files(1, 190)));
}

TEST(file_watch, reads_no_change_that_was_taken_back) {
  Looks look(files(1));
  EXPECT_FALSE(look(files(2)));
  EXPECT_FALSE(look(files(1)));
  EXPECT_FALSE(look(files(1)));
}

TEST(file_watch, reads_each_change_once) {
  Looks look(files(1));
  look(files(2));
  ASSERT_TRUE(look(files(2)));
  look.watch.was_read(files(2));
  for (int i = 0; i < 3; ++i) EXPECT_FALSE(look(files(2)));
  look(files(3));
  EXPECT_TRUE(look(files(3)));
}

TEST(file_watch, reads_again_what_changed_during_a_read) {
  Looks look(files(1));
  look(files(2));
  ASSERT_TRUE(look(files(2)));
  look.watch.was_read(files(2));  // the stamps from before that read
  EXPECT_FALSE(look(files(3)));
  EXPECT_TRUE(look(files(3)));
}

class file_stamps : public testing::Test {
 protected:
  void SetUp() override { fs::create_directories(folder_ / "below"); }
  void TearDown() override { fs::remove_all(folder_); }

  fs::path folder_ = fs::canonical(fs::temp_directory_path()) / ("file_stamps" + std::to_string(::getpid()));
};

TEST_F(file_stamps, are_of_files_that_exist) {
  std::ofstream(folder_ / "a") << "four";
  const std::vector<fs::path> asked{folder_ / "a", folder_ / "b", folder_ / "below"};
  const FileStamps stamps = stamps_of(asked);
  ASSERT_THAT(stamps, UnorderedElementsAre(Key(folder_ / "a")));
  EXPECT_EQ(stamps.begin()->second.bytes, 4u);
  EXPECT_EQ(stamps.begin()->second.written, fs::last_write_time(folder_ / "a"));
}

TEST_F(file_stamps, of_a_folder_are_of_its_files_alone) {
  std::ofstream(folder_ / "a") << 1;
  std::ofstream(folder_ / "below" / "b") << 2;
  FileStamps stamps;
  add_stamps_in(folder_, stamps);
  EXPECT_THAT(stamps, UnorderedElementsAre(Key(folder_ / "a")));
  add_stamps_in(folder_ / "nowhere", stamps);
  EXPECT_EQ(stamps.size(), 1u);
}

TEST_F(file_stamps, have_one_key_for_a_file_however_it_is_called) {
  const fs::path plain = folder_ / "a";
  EXPECT_EQ(stamp_key(plain), plain);
  EXPECT_EQ(stamp_key(folder_ / "below" / ".." / "a"), plain);
  fs::create_directory_symlink(folder_, folder_ / "below" / "link");
  EXPECT_EQ(stamp_key(folder_ / "below" / "link" / "a"), plain);
  EXPECT_EQ(stamp_key("a"), fs::canonical(fs::current_path()) / "a");
  EXPECT_EQ(stamp_key(folder_ / "nowhere" / "a"), folder_ / "nowhere" / "a");
}

}  // namespace
}  // namespace sinew::viewer
