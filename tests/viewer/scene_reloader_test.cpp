// SPDX-License-Identifier: MIT
// Reloading of changed files: which files are watched, when they are reloaded, and the messages.
#include "viewer/app/reload/scene_reloader.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <future>
#include <iterator>
#include <new>
#include <string>
#include <thread>

namespace sinew::viewer {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using Said = std::function<void(const std::string&)>;
using Read = tl::expected<LoadedScene, LoadError>;

/// A folder with the file "thing". A read gives its text as the note of a scene. Lines "names FILE" name further
/// files, which must exist; the text "broken" is an error.
class scene_reloader : public testing::Test {
 protected:
  void SetUp() override {
    fs::create_directories(folder_);
    write("thing", "first");
    watch_ = std::make_unique<SceneReloader>(file("thing"));
    watch_->was_read(read_now([](const std::string&) {})->files);
  }
  void TearDown() override {
    watch_.reset();
    fs::remove_all(folder_);
  }

  fs::path file(const std::string& name) const { return folder_ / name; }

  // Gives each write a distinct modification time.
  void write(const std::string& name, const std::string& text) {
    std::ofstream(file(name)) << text;
    fs::last_write_time(file(name), fs::file_time_type(std::chrono::seconds(++writes_)));
  }

  Read read_now(const Said& log_line) const {
    std::ifstream in(file("thing"));
    if (!in) return tl::unexpected(LoadError{1, "there is no such file"});
    const std::string text{std::istreambuf_iterator<char>(in), {}};
    log_line("read " + text);
    if (text == "broken") return tl::unexpected(LoadError{1, "it is broken"});
    LoadedScene loaded;
    loaded.note = text;
    loaded.files = {file("thing")};
    if (text.rfind("names ", 0) == 0) {
      loaded.files.push_back(file(text.substr(6)));
      if (!fs::exists(loaded.files.back())) return tl::unexpected(LoadError{1, "a file is missing"});
    }
    return loaded;
  }

  void look() {
    now_s_ += FileWatch::kPeriod_s;
    watch_->look(now_s_, [this] {
      ++reads_;
      return [this](const Said& log_line) { return read_now(log_line); };
    });
  }

  // The result of a few checks: the scene's note, the error, or empty if nothing was reloaded.
  std::string after_looks() {
    const int before = reads_;
    for (int i = 0; i < 3 && reads_ == before; ++i) look();
    if (reads_ == before) return "nothing";
    for (;; std::this_thread::yield())
      if (auto read = watch_->take()) {
        messages_ = read->messages;
        return read->loaded ? read->loaded->note : read->loaded.error().message;
      }
  }

  fs::path folder_ = fs::temp_directory_path() / ("scene_reloader" + std::to_string(::getpid()));
  std::unique_ptr<SceneReloader> watch_;
  std::vector<std::string> messages_;
  double now_s_ = 0.0;
  int writes_ = 0, reads_ = 0;
};

TEST_F(scene_reloader, reads_nothing_until_the_file_changes) {
  EXPECT_EQ(after_looks(), "nothing");
  write("thing", "second");
  EXPECT_EQ(after_looks(), "second");
  EXPECT_THAT(messages_, ElementsAre("read second"));
  EXPECT_EQ(after_looks(), "nothing");
}

TEST_F(scene_reloader, looks_no_more_often_than_four_times_a_second) {
  write("thing", "second");
  now_s_ = 10.0;
  look();
  for (int i = 0; i < 20; ++i) watch_->look(now_s_ + 0.01 * i, [] { return BackgroundReload::Read(); });
  EXPECT_EQ(reads_, 0);
  look();
  EXPECT_EQ(reads_, 1);
}

TEST_F(scene_reloader, sees_a_change_during_the_first_read) {
  SceneReloader early(file("thing"));
  const auto first = read_now([](const std::string&) {});
  write("thing", "second");
  early.was_read(first->files);
  *watch_ = std::move(early);
  EXPECT_EQ(after_looks(), "second");
}

TEST_F(scene_reloader, fails_once_for_each_change_and_reads_the_next_one) {
  write("thing", "broken");
  EXPECT_EQ(after_looks(), "it is broken");
  EXPECT_EQ(after_looks(), "nothing");
  write("thing", "broken");
  EXPECT_EQ(after_looks(), "it is broken");
  EXPECT_EQ(after_looks(), "nothing");
  write("thing", "whole");
  EXPECT_EQ(after_looks(), "whole");
  EXPECT_EQ(after_looks(), "nothing");
}

TEST_F(scene_reloader, follows_a_file_that_goes_and_comes_back) {
  fs::remove(file("thing"));
  EXPECT_EQ(after_looks(), "there is no such file");
  EXPECT_EQ(after_looks(), "nothing");
  write("new", "second");
  fs::rename(file("new"), file("thing"));
  EXPECT_EQ(after_looks(), "second");
}

TEST_F(scene_reloader, follows_the_files_that_the_file_names) {
  write("part", "1");
  EXPECT_EQ(after_looks(), "nothing") << "no one names it yet";
  write("thing", "names part");
  EXPECT_EQ(after_looks(), "names part");
  write("part", "2");
  EXPECT_EQ(after_looks(), "names part");
  write("thing", "alone");
  EXPECT_EQ(after_looks(), "alone");
  write("part", "3");
  EXPECT_EQ(after_looks(), "nothing") << "no one names it any more";
}

TEST_F(scene_reloader, reads_again_when_a_file_comes_that_was_missing) {
  write("thing", "names part");
  EXPECT_EQ(after_looks(), "a file is missing");
  EXPECT_EQ(after_looks(), "nothing");
  write("part", "1");
  EXPECT_EQ(after_looks(), "names part");
  write("other", "1");
  EXPECT_EQ(after_looks(), "nothing") << "the folder counts after a failed read only";
}

TEST_F(scene_reloader, after_a_failed_read_waits_for_new_files_alone) {
  write("log", "1");
  write("thing", "names part");
  EXPECT_EQ(after_looks(), "a file is missing");
  write("log", "2");
  EXPECT_EQ(after_looks(), "nothing") << "the program itself may write there";
  write("note", "1");
  EXPECT_EQ(after_looks(), "a file is missing");
  EXPECT_EQ(after_looks(), "nothing");
  write("log", "3");
  EXPECT_EQ(after_looks(), "nothing");
  write("note", "2");
  EXPECT_EQ(after_looks(), "a file is missing") << "it may have come half written";
  write("part", "1");
  EXPECT_EQ(after_looks(), "names part");
}

TEST_F(scene_reloader, sees_a_change_of_a_named_file_during_a_read) {
  write("part", "1");
  std::promise<void> may_end;
  write("thing", "names part");
  const auto slow = [&] {
    return [&](const Said& log_line) {
      auto read = read_now(log_line);
      may_end.get_future().wait();
      return read;
    };
  };
  for (int i = 1; i <= 2; ++i) watch_->look(i * FileWatch::kPeriod_s, slow);
  EXPECT_FALSE(watch_->take());
  for (int i = 3; i <= 9; ++i) watch_->look(i * FileWatch::kPeriod_s, slow);  // one read at a time
  write("part", "2");
  may_end.set_value();
  while (!watch_->take()) std::this_thread::yield();
  now_s_ = 10.0;
  EXPECT_EQ(after_looks(), "names part") << "the part is newer than what was read";
  EXPECT_EQ(after_looks(), "nothing");
}

TEST(background_reload, gives_its_result_once) {
  BackgroundReload read;
  EXPECT_FALSE(read.running() || read.take());
  std::promise<void> may_end;
  read.begin([&](const Said& log_line) -> Read {
    may_end.get_future().wait();
    log_line("a line");
    LoadedScene loaded;
    loaded.name = "thing";
    return loaded;
  });
  EXPECT_TRUE(read.running());
  EXPECT_FALSE(read.take());
  may_end.set_value();
  std::optional<ReloadResult> result;
  while (!(result = read.take())) std::this_thread::yield();
  EXPECT_EQ(result->loaded->name, "thing");
  EXPECT_THAT(result->messages, ElementsAre("a line"));
  EXPECT_FALSE(read.running() || read.take());
}

TEST(background_reload, that_runs_out_of_memory_is_an_error) {
  BackgroundReload read;
  read.begin([](const Said& log_line) -> Read {
    log_line("a line");
    throw std::bad_alloc();
  });
  std::optional<ReloadResult> result;
  while (!(result = read.take())) std::this_thread::yield();
  ASSERT_FALSE(result->loaded);
  EXPECT_EQ(result->loaded.error().message, "out of memory");
  EXPECT_THAT(result->messages, ElementsAre("a line"));
}

TEST(background_reload, ends_while_it_runs) {
  bool ended = false;
  {
    BackgroundReload read;
    read.begin([&](const Said&) -> Read {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      ended = true;
      return LoadedScene();
    });
  }
  EXPECT_TRUE(ended);
}

}  // namespace
}  // namespace sinew::viewer
