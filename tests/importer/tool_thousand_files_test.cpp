// SPDX-License-Identifier: MIT
// A thousand small files are checked, some of them broken. Output has the same bytes for any number of jobs, the
// summary is true, and memory does not grow with the number of files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tests/importer/tool_model.h"
#include "tests/support/allocation_counter.h"

namespace sinew::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

enum class Kind { sound, cut, broken, warned };

Kind kind_of(std::size_t i) {
  if (i % 50 == 7) return Kind::cut;
  if (i % 25 == 3) return Kind::broken;
  return i % 10 == 1 ? Kind::warned : Kind::sound;
}

/// Files 0 to count - 1 in folders of a hundred.
class ManyFiles {
 public:
  explicit ManyFiles(std::size_t count) {
    const std::string sound = tool_model();
    for (std::size_t i = 0; i < count; ++i) {
      const fs::path file = fs::path(root()) / fmt::format("{:02}", i / 100) / fmt::format("{:04}.gltf", i);
      fs::create_directories(file.parent_path());
      std::ofstream stream(file, std::ios::binary);
      switch (kind_of(i)) {
        case Kind::sound: stream << sound; break;
        case Kind::cut: stream << sound.substr(0, sound.size() / 2); break;
        case Kind::broken: stream << R"({"asset": {"version": "2.0"}, "nodes": [{"mesh": 5}, {"mesh": 6}]})"; break;
        case Kind::warned: stream << R"({"asset": {"version": "2.0"}, "nodes": [{"rotation": [0, 0, 0, 2]}]})"; break;
      }
    }
  }
  std::string root() const { return place_.beside("assets"); }

 private:
  ToolModelFile place_;
};

TEST(thousand_files, are_checked_with_one_job_or_all_to_the_same_bytes_and_a_true_summary) {
  const ManyFiles files(1000);
  const CommandOutcome one = run_tool({"check", files.root(), "--recursive", "--jobs", "1"});
  const CommandOutcome all = run_tool({"check", files.root(), "--recursive"});
  const CommandOutcome more = run_tool({"check", files.root(), "--recursive", "--jobs", "7"});
  EXPECT_EQ(one.status, 1);
  EXPECT_EQ(one.out, all.out);
  EXPECT_EQ(one.out, more.out);
  std::size_t cut = 0, broken = 0, warned = 0;
  for (std::size_t i = 0; i < 1000; ++i) {
    cut += kind_of(i) == Kind::cut ? 1 : 0;
    broken += kind_of(i) == Kind::broken ? 1 : 0;
    warned += kind_of(i) == Kind::warned ? 1 : 0;
  }
  EXPECT_THAT(one.out,
              testing::HasSubstr(fmt::format("\n1000 files: {} done, {} failed; {} errors, {} warnings, 0 infos;",
                                             1000 - cut - broken, cut + broken, cut + 2 * broken, warned)));
}

TEST(thousand_files, take_no_more_memory_than_a_hundred_but_for_their_names) {
  const auto peak_of = [](std::size_t count) {
    const ManyFiles files(count);
    const PeakMemory peak;
    run_tool({"check", files.root(), "--recursive", "--jobs", "1"});
    return peak.bytes();
  };
  const std::size_t few = peak_of(100), many = peak_of(1000);
  EXPECT_LT(many, few + 900 * 1024) << "a kilobyte a file: its name, twice, and its line in this test";
}

TEST(thousand_files, are_told_as_documents_in_the_order_of_their_names) {
  const ManyFiles files(200);
  const std::vector<std::string> command = {"check", files.root(), "--recursive", "--json", "--jobs"};
  const auto with_jobs = [&](const char* jobs) {
    std::vector<std::string> arguments = command;
    arguments.push_back(jobs);
    return run_tool(arguments).out;
  };
  const std::string text = with_jobs("1");
  EXPECT_EQ(text, with_jobs("4"));
  std::istringstream stream(text);
  std::string before;
  std::size_t count = 0, failed = 0;
  for (std::string line; std::getline(stream, line); ++count) {
    const json document = json::parse(line);
    const std::string file = document["file"];
    EXPECT_LT(before, file);
    before = file;
    failed += document["errors"] > 0 ? 1 : 0;
  }
  EXPECT_EQ(count, 200u);
  EXPECT_EQ(failed, 12u);
}

}  // namespace
}  // namespace sinew::test
