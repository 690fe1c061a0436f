// SPDX-License-Identifier: MIT
// One command, many files: which files folders stand for, the order of what is printed, and how much is held at a time.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <sstream>
#include <thread>

#include <nlohmann/json.hpp>

#include "importer/tool/batch/batch_progress.h"
#include "importer/tool/batch/in_order.h"
#include "importer/tool/batch/input_list.h"
#include "tests/importer/tool_model.h"
#include "tests/support/file_text.h"

namespace sinew::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* kBroken = R"({"asset": {"version": "2.0"}, "nodes": [{"mesh": 5}]})";
constexpr const char* kWarned = R"({"asset": {"version": "2.0"}, "nodes": [
  {"rotation": [0, 0, 0, 2]}, {"rotation": [0, 0, 0, 3]}, {"rotation": [0, 0, 0, 4]}]})";

std::vector<std::string> lines(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> out;
  for (std::string line; std::getline(stream, line);) out.push_back(line);
  return out;
}

/// "PATH" of a file, "PATH: REMARK" of a remark, below `folder`.
std::vector<std::string> listed(const std::vector<std::string>& arguments, bool recursive, const std::string& folder) {
  std::vector<std::string> out;
  for (const tool::Input& input : tool::list_inputs(arguments, recursive).inputs) {
    const std::string path = input.path.starts_with(folder) ? input.path.substr(folder.size()) : input.path;
    out.push_back(input.remark.empty() ? path : path + ": " + input.remark);
  }
  return out;
}

TEST(many_files, check_takes_the_asset_files_of_a_folder) {
  const ToolModelFile place;
  const std::string root = place.beside("checked");
  write_file(root + "/b.SINEW", "not an asset file");
  write_file(root + "/a.gltf", kWarned);
  write_file(root + "/c.sgeo", "of another command");
  const tool::InputList models = tool::list_inputs({root}, false);
  ASSERT_EQ(models.inputs.size(), 1u) << "other commands take models only";
  const tool::InputList both = tool::list_inputs({root}, false, tool::FileKind::models_and_assets);
  ASSERT_EQ(both.inputs.size(), 2u);
  EXPECT_EQ(both.inputs[0].below, "a.gltf");
  EXPECT_EQ(both.inputs[1].below, "b.SINEW");
  const CommandOutcome checked = run_tool({"check", root});
  EXPECT_EQ(checked.status, 1) << "the asset file is broken";
  EXPECT_THAT(checked.out, HasSubstr(root + "/b.SINEW: "));
}

TEST(many_files, a_folder_stands_for_the_models_in_it_by_name) {
  const ToolModelFile place;
  const std::string root = place.beside("assets");
  for (const char* file : {"/b.glb", "/a.gltf", "/c.VRM", "/a.bin", "/picture.png", "/d/e.glb", "/d/f/g.gltf"})
    write_file(root + file, "");
  EXPECT_THAT(listed({root}, false, root), ElementsAre("/a.gltf", "/b.glb", "/c.VRM"));
  EXPECT_THAT(listed({root}, true, root), ElementsAre("/a.gltf", "/b.glb", "/c.VRM", "/d/e.glb", "/d/f/g.gltf"));
  EXPECT_THAT(listed({root + "/d", "x.glb", "-"}, true, root), ElementsAre("/d/e.glb", "/d/f/g.gltf", "x.glb", "-"));
  const auto list = tool::list_inputs({root + "/d", "some/x.glb"}, true);
  EXPECT_EQ(list.inputs[1].below, "f/g.gltf") << "below the folder that was given";
  EXPECT_EQ(list.inputs[2].below, "x.glb");
  EXPECT_TRUE(list.many);
  EXPECT_FALSE(tool::list_inputs({"x.glb"}, true).many);
  EXPECT_TRUE(tool::list_inputs({root + "/d/f"}, true).many) << "a folder, also with one file";
}

TEST(many_files, a_folder_without_models_is_a_fault_that_says_what_helps) {
  const ToolModelFile place;
  const std::string root = place.beside("assets");
  write_file(root + "/d/e.glb", "");
  fs::create_directory(root + "/empty");
  EXPECT_THAT(listed({root + "/empty"}, true, root), ElementsAre("/empty: holds no .glb, .gltf or .vrm file"));
  EXPECT_THAT(listed({root}, false, root), ElementsAre(HasSubstr("--recursive looks into its folders")));
  const CommandOutcome outcome = run_tool({"check", root + "/empty"});
  EXPECT_EQ(outcome.status, 1) << "a wrong path must not pass";
  EXPECT_THAT(outcome.out, testing::StartsWith("0 files: "));
}

TEST(many_files, loops_of_links_are_told_and_end) {
  const ToolModelFile place;
  const std::string root = place.beside("assets");
  write_file(root + "/a.gltf", tool_model());
  write_file(root + "/d/b.gltf", tool_model());
  fs::create_directory_symlink(root, root + "/d/loop");
  fs::create_directory_symlink(root + "/d", root + "/e");
  EXPECT_THAT(
      listed({root}, true, root),
      ElementsAre("/a.gltf", "/d/b.gltf", "/d/loop: leads to a folder that was looked into already; it is left out",
                  "/e: leads to a folder that was looked into already; it is left out"));
  const CommandOutcome outcome = run_tool({"check", root, "--recursive"});
  EXPECT_EQ(outcome.status, 0) << "every file was checked";
  EXPECT_THAT(outcome.err, HasSubstr("sinew: " + root + "/d/loop: leads to a folder"));
  EXPECT_THAT(outcome.out, HasSubstr("\n2 files: 2 done, 0 failed"));
}

TEST(many_files, a_folder_that_cannot_be_read_is_told_and_the_others_are_read) {
  const ToolModelFile place;
  const std::string root = place.beside("assets");
  write_file(root + "/a.gltf", tool_model());
  write_file(root + "/closed/b.gltf", tool_model());
  write_file(root + "/d/c.gltf", tool_model());
  fs::permissions(root + "/closed", fs::perms::none);
  const bool all_powerful = geteuid() == 0;
  fs::permissions(fs::path(root).parent_path(), fs::perms::all);
  if (all_powerful && seteuid(65534) != 0) GTEST_SKIP() << "this user may read everything";
  const CommandOutcome outcome = run_tool({"check", root, "--recursive"});
  if (all_powerful) {
    ASSERT_EQ(seteuid(0), 0);
  }
  fs::permissions(root + "/closed", fs::perms::all);
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("sinew: " + root + "/closed: cannot be read: "));
  EXPECT_THAT(outcome.out, HasSubstr("\n2 files: 2 done, 0 failed"));
}

TEST(many_files, outcomes_come_in_order_and_few_wait) {
  for (const std::size_t jobs : {1u, 2u, 4u}) {
    std::atomic<std::size_t> running = 0, begun = 0, most_running = 0, most_held = 0;
    std::size_t shown = 0;
    const auto raise = [](std::atomic<std::size_t>& most, std::size_t value) {
      for (std::size_t old = most; old < value && !most.compare_exchange_weak(old, value);) {
      }
    };
    std::atomic<std::size_t> shown_so_far = 0;
    tool::run_in_order(
        300, jobs,
        [&](std::size_t i) {
          raise(most_running, ++running);
          raise(most_held, ++begun - shown_so_far);
          for (int tries = 0; i < jobs && most_running < jobs && tries < 60'000; ++tries)  // until all jobs are here
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
          if (i % 17 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(5));  // others wait for this one
          --running;
          return tool::JobOutcome{tool::ExitCode::done, std::to_string(i), {}};
        },
        [&](std::size_t i, tool::JobOutcome&& outcome) {
          EXPECT_EQ(i, shown++);
          EXPECT_EQ(outcome.results, std::to_string(i));
          ++shown_so_far;
        });
    EXPECT_EQ(shown, 300u);
    EXPECT_LE(most_held, tool::kWaitingPerJob * jobs);
    EXPECT_EQ(most_running, jobs) << "each job has a thread";
  }
}

TEST(many_files, outcomes_that_wait_hold_no_more_text_than_allowed) {
  constexpr std::size_t kBytes = 1000, kMost = 20'000, kJobs = 3;
  std::atomic<std::size_t> finished = 0, shown = 0;
  std::size_t most_waiting = 0;
  tool::run_in_order(
      200, kJobs,
      [&](std::size_t i) {
        for (int tries = 0; i == 0 && finished * kBytes <= kMost && tries < 60'000; ++tries)  // all others wait for it
          std::this_thread::sleep_for(std::chrono::milliseconds(1));
        if (i == 0) std::this_thread::sleep_for(std::chrono::milliseconds(50));
        ++finished;
        return tool::JobOutcome{tool::ExitCode::done, std::string(kBytes, 'a'), {}};
      },
      [&](std::size_t, tool::JobOutcome&&) { most_waiting = std::max<std::size_t>(most_waiting, finished - shown++); },
      kMost);
  EXPECT_EQ(shown, 200u);
  EXPECT_GT(most_waiting, 4 * kJobs) << "small files are worked on beside a large one";
  EXPECT_LE(most_waiting, kMost / kBytes + 2 * kJobs);
}

TEST(many_files, each_has_one_line_and_a_summary_follows) {
  const ToolModelFile model;
  const std::string broken = model.beside("broken.gltf"), warned = model.beside("warned.gltf");
  write_file(broken, kBroken);
  write_file(warned, kWarned);
  const CommandOutcome outcome = run_tool({"check", warned, broken, model.path()});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(outcome.out, warned + ": 3 warnings: rotation-length x3\n" + broken + ": 1 error: reference\n" +
                             model.path() +
                             ": ok\n3 files: 2 done, 1 failed; 1 error, 3 warnings, 0 infos; most often "
                             "rotation-length x3, reference x1\n");
  EXPECT_THAT(outcome.err, IsEmpty());
  const CommandOutcome info = run_tool({"info", broken, model.path()});
  EXPECT_EQ(info.status, 1);
  EXPECT_THAT(lines(info.out), ElementsAre(broken + ": failed", HasSubstr(" 4 nodes, 2 meshes, 7 vertices, 1 triangle"),
                                           "2 files: 1 done, 1 failed"));
  EXPECT_THAT(info.err, testing::StartsWith("sinew: " + broken + ": /nodes/0/mesh: reference: "));
  const CommandOutcome plan = run_tool({"plan", model.path(), model.path()});
  EXPECT_THAT(lines(plan.out),
              ElementsAre(HasSubstr(" stages run, "), HasSubstr(" stages run, "), HasSubstr("2 files: ")));
}

TEST(many_files, the_summary_counts_cases_that_no_line_has) {
  const ToolModelFile model;
  const std::string file = model.beside("long.gltf"), broken = model.beside("broken.gltf");
  nlohmann::json nodes = nlohmann::json::array();
  for (int n = 0; n < 183; ++n) nodes.push_back({{"rotation", {0, 0, 0, 2}}});
  write_file(file, nlohmann::json{{"asset", {{"version", "2.0"}}}, {"nodes", nodes}}.dump());
  write_file(broken, kBroken);
  EXPECT_THAT(run_tool({"check", file, broken, file}).out,
              testing::EndsWith("1 error, 366 warnings, 0 infos; most often rotation-length x366, reference x1\n"));
}

TEST(many_files, json_is_one_document_a_line_also_for_those_that_fail) {
  const ToolModelFile model;
  const std::string broken = model.beside("broken.gltf");
  write_file(broken, kBroken);
  for (const char* command : {"check", "info", "plan"}) {
    const CommandOutcome outcome = run_tool({command, "--json", broken, model.path()});
    EXPECT_EQ(outcome.status, 1) << command;
    const auto documents = lines(outcome.out);
    ASSERT_EQ(documents.size(), 2u) << command;
    EXPECT_EQ(json::parse(documents[0])["file"], broken) << command;
    EXPECT_EQ(json::parse(documents[1])["file"], model.path()) << command;
    EXPECT_THAT(outcome.err, HasSubstr("2 files: 1 done, 1 failed")) << command;
  }
  const json failed = json::parse(lines(run_tool({"info", "--json", broken, model.path()}).out)[0]);
  EXPECT_EQ(failed["failed"], true);
  EXPECT_THAT(failed["messages"][0].get<std::string>(), testing::StartsWith(broken + ": /nodes/0/mesh: "));
}

TEST(many_files, one_file_is_told_as_ever) {
  const ToolModelFile model;
  EXPECT_EQ(run_tool({"check", model.path()}).out, model.path() + ": 0 errors, 0 warnings\n");
  const std::string document = run_tool({"check", model.path(), "--json"}).out;
  EXPECT_GT(lines(document).size(), 3u) << "indented";
  EXPECT_EQ(run_tool({"plan", model.path(), "--json"}).out.find("\"file\""), std::string::npos);
}

/// Gives a text as standard input while it lives.
class StandardInput {
 public:
  StandardInput(const std::string& file, const std::string& text) : before_(dup(STDIN_FILENO)) {
    write_file(file, text);
    open_at_standard_input(file);
  }
  explicit StandardInput(const std::string& folder) : before_(dup(STDIN_FILENO)) { open_at_standard_input(folder); }
  ~StandardInput() {
    dup2(before_, STDIN_FILENO);
    close(before_);
  }

 private:
  static void open_at_standard_input(const std::string& path) {
    const int opened = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    dup2(opened, STDIN_FILENO);
    close(opened);
  }

  int before_;
};

TEST(many_files, a_dash_is_the_standard_input) {
  const ToolModelFile model;
  for (const char* command : {"check", "info", "plan", "sample"}) {
    const StandardInput input(model.beside("input"), tool_model());
    EXPECT_EQ(run_tool({command, "-"}).status, 0) << command;
  }
  const StandardInput input(model.beside("input"), kBroken);
  const CommandOutcome outcome = run_tool({"check", model.path(), "-"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, HasSubstr("\n-: 1 error: reference\n"));
  EXPECT_EQ(run_tool({"check", "-", "-"}).status, 2) << "it can be read once";
}

TEST(many_files, a_standard_input_that_cannot_be_read_is_told) {
  const ToolModelFile model;
  const StandardInput input(model.beside(""));
  for (const char* command : {"check", "info", "plan", "sample"}) {
    const CommandOutcome outcome = run_tool({command, "-"});
    EXPECT_EQ(outcome.status, 1) << command;
    EXPECT_THAT(outcome.out + outcome.err, HasSubstr("Is a directory")) << command;
    EXPECT_THAT(outcome.out + outcome.err, HasSubstr("file-unreadable")) << command;
  }
}

TEST(many_files, time_left_has_the_unit_that_suits) {
  EXPECT_EQ(tool::time_left_text(0.2), "about 0 s left");
  EXPECT_EQ(tool::time_left_text(89.0), "about 89 s left");
  EXPECT_EQ(tool::time_left_text(120.0), "about 2 min left");
  EXPECT_EQ(tool::time_left_text(9000.0), "about 2.5 h left");
}

}  // namespace
}  // namespace sinew::test
