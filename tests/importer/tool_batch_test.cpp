// SPDX-License-Identifier: MIT
// `sinew batch` from outside: units in shards, killed and resumed, and one report.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>
#include <vector>

#include "importer/platform/program.h"
#include "importer/tool/units/unit.h"
#include "importer/tool/units/unit_result.h"
#include "tests/importer/tool_model.h"

extern char** environ;

namespace sinew::test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

/// Twelve models in two folders; two of them are broken.
class Batch : public testing::Test {
 protected:
  static constexpr int kModels = 12;

  Batch() : folder_(model_.beside("models")) {
    fs::create_directories(folder_ / "more");
    for (int i = 0; i < kModels; ++i) {
      std::ofstream file(folder_ / (i % 3 == 0 ? "more" : ".") / ("m" + std::to_string(i) + ".gltf"));
      file << (i % 5 == 4 ? std::string("{\"asset\": <broken & \"quoted\">") : tool_model());
    }
  }

  std::vector<std::string> words(const std::string& out, std::vector<std::string> more = {}) const {
    std::vector<std::string> all = {"batch", folder_.string(), "--do", "info {in}", "-o", model_.beside(out)};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  CommandOutcome batch(const std::string& out, std::vector<std::string> more = {}) const {
    return run_tool(words(out, std::move(more)));
  }
  std::vector<std::string> reports(const std::string& out) const {
    std::vector<std::string> texts;
    for (const char* name : {"report.json", "report.csv", "report.html"})
      texts.push_back(text_of(fs::path(model_.beside(out)) / name));
    return texts;
  }
  std::size_t results(const std::string& out) const {
    std::error_code error;
    const fs::directory_iterator entries(fs::path(model_.beside(out)) / "units", error);
    return error ? 0 : static_cast<std::size_t>(std::count_if(begin(entries), end(entries), [](const auto& entry) {
      return entry.path().extension() == ".json";
    }));
  }

  ToolModelFile model_;
  fs::path folder_;
};

TEST_F(Batch, reports_are_the_same_for_one_two_and_seven_shards) {
  const CommandOutcome whole = batch("one");
  EXPECT_EQ(whole.status, 1);
  EXPECT_THAT(whole.out, HasSubstr("m0.gltf: done\n"));
  EXPECT_THAT(whole.out, HasSubstr("m4.gltf: failed with status 1: sinew: "));
  EXPECT_THAT(whole.out, HasSubstr("12 units, 2 failed, 0 not run"));
  const std::vector<std::string> expected = reports("one");
  EXPECT_THAT(expected[0], HasSubstr("\"failed\": 2"));
  EXPECT_THAT(expected[1], HasSubstr("\"m1.gltf\",0,\""));
  EXPECT_LT(expected[2].find("m4.gltf"), expected[2].find("m1.gltf")) << "failures first";
  EXPECT_THAT(expected[2], Not(HasSubstr("<broken"))) << "texts of files are no markup";
  for (const int shards : {2, 7}) {
    const std::string out = "by" + std::to_string(shards), all = '/' + std::to_string(shards);
    for (int s = shards; s > 0; --s) {
      EXPECT_EQ(batch(out, {"--merge"}).status, 1) << "not all were run";
      EXPECT_LE(batch(out, {"--shard", std::to_string(s) + all, "--jobs", "2"}).status, 1);
    }
    EXPECT_EQ(batch(out, {"--merge"}).status, 1);
    EXPECT_EQ(reports(out), expected) << shards;
  }
}

TEST_F(Batch, what_was_killed_goes_on_and_nothing_is_done_twice) {
  batch("whole");
  std::vector<std::string> line = words("killed", {"--jobs", "1"});
  const std::string program = (platform::program_folder() / platform::program_file("sinew")).string();
  line.insert(line.begin(), program);
  std::vector<char*> argv;
  for (std::string& word : line) argv.push_back(word.data());
  argv.push_back(nullptr);
  pid_t process = 0;
  posix_spawn_file_actions_t silent;
  posix_spawn_file_actions_init(&silent);
  posix_spawn_file_actions_addopen(&silent, 1, "/dev/null", 1, 0);
  posix_spawn_file_actions_addopen(&silent, 2, "/dev/null", 1, 0);
  ASSERT_EQ(posix_spawn(&process, program.c_str(), &silent, nullptr, argv.data(), environ), 0);
  posix_spawn_file_actions_destroy(&silent);
  for (int i = 0; i < 60'000 && results("killed") < 3; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  kill(process, SIGKILL);
  waitpid(process, nullptr, 0);
  const std::size_t before = results("killed");
  EXPECT_GE(before, 3u);
  const std::string out = batch("killed").out;
  std::size_t kept = 0;
  for (std::size_t at = 0; (at = out.find("done before", at)) != std::string::npos; ++at) ++kept;
  EXPECT_GE(kept + 2, before) << "failures say their status again";
  EXPECT_EQ(results("killed"), static_cast<std::size_t>(kModels));
  EXPECT_EQ(reports("killed"), reports("whole"));
  EXPECT_THAT(batch("killed").out, Not(HasSubstr(": done\n"))) << "nothing is left";
}

TEST_F(Batch, a_unit_runs_again_where_its_file_or_the_command_changed_or_it_failed) {
  batch("out");
  const auto rerun = [&](std::vector<std::string> more = {}) {
    const std::string out = batch("out", std::move(more)).out;
    std::size_t count = 0;
    for (std::size_t at = 0; (at = out.find(": done\n", at)) != std::string::npos; ++at) ++count;
    return count;
  };
  EXPECT_EQ(rerun(), 0u);
  std::ofstream(folder_ / "m1.gltf", std::ios::app) << "\n";
  EXPECT_EQ(rerun(), 1u);
  std::ofstream(folder_ / "m4.gltf") << tool_model();
  EXPECT_EQ(rerun(), 1u) << "another file";
  fs::remove(folder_ / "more" / "m9.gltf");
  EXPECT_EQ(rerun({"--again"}), 0u) << "what failed still fails";
}

TEST_F(Batch, a_golden_that_changed_is_compared_again) {
  const std::string one = (folder_ / "m1.gltf").string(), golden = model_.beside("m1.json");
  ASSERT_EQ(run_tool({"sample", one, "--fps", "4", "-o", golden}).status, 0);
  const auto verify = [&] {
    return run_tool({"batch", one, "--do", "verify {in} " + model_.beside("{name}.json"), "-o", model_.beside("v")});
  };
  EXPECT_THAT(verify().out, HasSubstr("m1.gltf: done\n"));
  EXPECT_THAT(verify().out, HasSubstr("m1.gltf: done before\n"));
  ASSERT_EQ(run_tool({"sample", one, "--fps", "8", "-o", golden}).status, 0);
  EXPECT_THAT(verify().out, HasSubstr("m1.gltf: done\n"));
  std::ofstream(golden) << "{";
  const CommandOutcome broken = verify();
  EXPECT_EQ(broken.status, 1);
  EXPECT_THAT(broken.out, HasSubstr("m1.gltf: failed with status"));
}

TEST_F(Batch, outputs_take_the_names_of_their_files) {
  const CommandOutcome outcome =
      run_tool({"batch", folder_.string(), "--do", "convert '{in}' \"{out}.glb\"", "-o", model_.beside("converted")});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_TRUE(fs::exists(fs::path(model_.beside("converted")) / "files" / "more" / "m0.glb"));
  EXPECT_TRUE(fs::exists(fs::path(model_.beside("converted")) / "files" / "m1.glb"));
}

TEST_F(Batch, manifests_name_files_one_in_each_line) {
  std::ofstream(model_.beside("list.txt")) << "# models\n\nmodels/m1.gltf\r\nmodels/none.gltf\n";
  const CommandOutcome outcome =
      run_tool({"batch", model_.beside("list.txt"), "--do", "info {in}", "-o", model_.beside("m")});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, HasSubstr("models/m1.gltf: done"));
  EXPECT_THAT(outcome.out, HasSubstr("models/none.gltf: failed with status"));
  EXPECT_THAT(outcome.out, HasSubstr("1 not run")) << "what cannot be read has no hash";
}

TEST_F(Batch, scripts_run_all_shards) {
  EXPECT_EQ(batch("s", {"--emit", "slurm"}).status, 2) << "nothing is measured";
  EXPECT_THAT(batch("s", {"--emit", "slurm", "--shards", "3"}).out, HasSubstr("#SBATCH --array=1-3\n"));
  batch("s", {"--shard", "1/4"});
  EXPECT_THAT(batch("s", {"--emit", "parallel", "--shard-seconds", "1000"}).out, HasSubstr("--shard 1/1\n"));
  const std::string make = batch("s", {"--emit", "make", "--shards", "3"}).out;
  std::ofstream(model_.beside("Makefile")) << make;
  if (std::system("make --version > /dev/null 2>&1") != 0) GTEST_SKIP() << "make is not installed";
  const std::string path = "PATH='" + platform::program_folder().string() + "':\"$PATH\" ";
  const std::string line = path + "make -j2 -f '" + model_.beside("Makefile") + "' > /dev/null 2>&1";
  EXPECT_NE(std::system(line.c_str()), 0) << "two files are broken";
  batch("whole");
  EXPECT_EQ(reports("s"), reports("whole"));
}

TEST_F(Batch, misuse_is_named) {
  const auto error_of = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "batch");
    const CommandOutcome outcome = run_tool(arguments);
    EXPECT_NE(outcome.status, 0);
    return outcome.err;
  };
  const std::string in = folder_.string(), out = model_.beside("x");
  EXPECT_THAT(error_of({in, "--do", "info", "-o", out}), HasSubstr("does not say where the file stands: {in}"));
  EXPECT_THAT(error_of({in, "--do", "info '{in}", "-o", out}), HasSubstr("a quotation mark has no partner"));
  for (const char* shard : {"0/2", "3/2", "1", "a/b", "1/2x"})
    EXPECT_THAT(error_of({in, "--do", "info {in}", "-o", out, "--shard", shard}), HasSubstr("I/N")) << shard;
  EXPECT_THAT(error_of({model_.beside("none"), "--do", "info {in}", "-o", out}), HasSubstr("cannot be read"));
  std::ofstream(folder_ / "m1.glb") << "other";
  EXPECT_THAT(error_of({in, "--do", "info {in}", "-o", out}), HasSubstr("has the output of"));
}

TEST(split_words, as_a_shell_does) {
  EXPECT_THAT(*tool::split_words("verify  {in} 'a b'\"c\" ''"), ElementsAre("verify", "{in}", "a bc", ""));
  EXPECT_FALSE(tool::split_words("a \"b"));
  EXPECT_TRUE(tool::split_words("")->empty());
}

TEST(unit_result, half_a_file_is_no_result) {
  const ToolModelFile folder;
  const fs::path file = folder.beside("u.json");
  ASSERT_TRUE(tool::write_result(file, {"a", 3, "x\nlast\n\n", 0.5}));
  const auto read = tool::read_result(file);
  ASSERT_TRUE(read);
  EXPECT_EQ(read->last_line(), "last");
  EXPECT_EQ(read->status, 3);
  const std::string text = text_of(file);
  for (std::size_t bytes = 0; bytes + 2 < text.size(); ++bytes) {
    std::ofstream(file, std::ios::binary) << text.substr(0, bytes);
    EXPECT_FALSE(tool::read_result(file)) << bytes;
  }
}

}  // namespace
}  // namespace sinew::test
