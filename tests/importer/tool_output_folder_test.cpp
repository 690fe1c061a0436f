// SPDX-License-Identifier: MIT
// Commands that write a file for each input: where outputs go, and what they never replace.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <utility>

#include "tests/importer/tool_model.h"
#include "tests/support/file_text.h"

namespace sinew::test {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

/// All files below a folder, by name.
std::vector<std::string> files_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) names.push_back(fs::relative(entry.path(), folder).string());
  std::sort(names.begin(), names.end());
  return names;
}

/// Two models, one in a folder of its own.
class OutputFolder : public testing::Test {
 protected:
  OutputFolder() {
    write_file(in_ + "/a.gltf", tool_model());
    write_file(in_ + "/b/c.gltf", tool_model());
  }
  CommandOutcome run(std::vector<std::string> arguments) {
    arguments.push_back("--recursive");
    return run_tool(arguments);
  }

  ToolModelFile place_;
  std::string in_ = place_.beside("in"), out_ = place_.beside("out");
};

TEST_F(OutputFolder, has_the_folders_of_the_inputs) {
  const CommandOutcome compiled = run({"compile", in_, "-o", out_});
  EXPECT_EQ(compiled.status, 0) << compiled.err;
  EXPECT_THAT(compiled.out, HasSubstr(out_ + "/b/c.sinew: 2 clips, "));
  EXPECT_EQ(run({"convert", in_, out_}).status, 0);
  EXPECT_EQ(run({"sample", in_, "-o", out_}).status, 0);
  EXPECT_EQ(run({"sample", in_, "-o", out_, "--format", "csv"}).status, 0);
  EXPECT_THAT(files_in(out_),
              ElementsAre("a.csv", "a.glb", "a.json", "a.sinew", "b/c.csv", "b/c.glb", "b/c.json", "b/c.sinew"));
  EXPECT_EQ(text_of_file(out_ + "/a.glb"), text_of_file(out_ + "/b/c.glb"));
}

TEST_F(OutputFolder, is_what_verify_compares_a_folder_with) {
  ASSERT_EQ(run({"sample", in_, "-o", out_}).status, 0);
  const CommandOutcome same = run({"verify", in_, out_});
  EXPECT_EQ(same.status, 0) << same.err;
  EXPECT_THAT(same.out, HasSubstr("\n2 files: 2 done, 0 failed\n"));
  std::string moved = tool_model();
  moved.replace(moved.find("\"scale\": [1, 2, 1]"), 18, "\"scale\": [1, 3, 1]");
  write_file(in_ + "/b/c.gltf", moved);
  const CommandOutcome outcome = run({"verify", in_, out_});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 3) << "one line each";
  EXPECT_THAT(outcome.err, HasSubstr("sinew: " + in_ + "/b/c.gltf: poses differ from " + out_ + "/b/c.json\n"));
  fs::remove(out_ + "/a.json");
  EXPECT_EQ(run({"verify", in_, out_}).status, 4) << "not being able to compare is worse than a pose that moved";
}

TEST_F(OutputFolder, convert_writes_gltf_with_buffers_where_the_format_says_so) {
  const CommandOutcome outcome = run({"convert", in_, out_, "--format", "gltf"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(files_in(out_), ElementsAre("a.bin", "a.gltf", "b/c.bin", "b/c.gltf"));
  EXPECT_EQ(run({"convert", out_, place_.beside("again"), "--format", "glb"}).status, 0);
  EXPECT_EQ(run({"convert", in_, place_.beside("at_once")}).status, 0);
  for (const char* file : {"/a.glb", "/b/c.glb"})
    EXPECT_TRUE(text_of_file(place_.beside("again") + file) == text_of_file(place_.beside("at_once") + file));
}

TEST_F(OutputFolder, a_format_that_the_name_of_the_output_contradicts_is_wrong_usage) {
  const std::string glb = place_.beside("x.glb"), gltf = place_.beside("x.gltf");
  for (const auto& [out, format] : {std::pair(glb, "gltf"), {gltf, "glb"}, {"-", "gltf"}}) {
    const CommandOutcome outcome = run_tool({"convert", in_ + "/a.gltf", out, "--format", format});
    EXPECT_EQ(outcome.status, 2) << out;
    EXPECT_THAT(outcome.err, HasSubstr(out)) << out;
  }
  EXPECT_EQ(run_tool({"convert", in_ + "/a.gltf", gltf, "--format", "gltf"}).status, 0);
}

TEST_F(OutputFolder, convert_takes_files_and_folders_in_one_list) {
  const CommandOutcome outcome = run_tool({"convert", in_ + "/a.gltf", in_ + "/b", "--quantize", out_});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("\n2 files: 2 done, 0 failed\n"));
  EXPECT_THAT(files_in(out_), ElementsAre("a.glb", "c.glb"));
  EXPECT_EQ(run_tool({"convert", in_ + "/a.gltf"}).status, 2) << "OUT is missing";
  const CommandOutcome to_stdout = run_tool({"convert", in_ + "/a.gltf", in_ + "/b", "-"});
  EXPECT_EQ(to_stdout.status, 2);
  EXPECT_THAT(to_stdout.err, HasSubstr("several files need a folder"));
  EXPECT_FALSE(fs::exists("-"));
}

TEST_F(OutputFolder, verify_takes_files_and_folders_in_one_list) {
  ASSERT_EQ(run_tool({"sample", in_ + "/a.gltf", in_ + "/b", "-o", out_}).status, 0);
  const CommandOutcome several = run_tool({"verify", in_ + "/a.gltf", in_ + "/b", "--exact", out_});
  EXPECT_EQ(several.status, 0) << several.err;
  EXPECT_THAT(several.out, HasSubstr("\n2 files: 2 done, 0 failed\n"));
  EXPECT_EQ(run_tool({"verify", in_ + "/a.gltf", out_}).status, 0) << "one file, and the folder of its poses";
  EXPECT_EQ(run_tool({"verify", in_ + "/a.gltf"}).status, 2) << "GOLDEN is missing";
  const CommandOutcome no_golden = run_tool({"verify", in_});
  EXPECT_EQ(no_golden.status, 4) << "nothing was compared";
  EXPECT_THAT(no_golden.err, HasSubstr("holds no geometry cache"));
  EXPECT_EQ(run_tool({"verify", in_, place_.beside("none")}).status, 4);
}

TEST_F(OutputFolder, one_bad_file_does_not_stop_the_others) {
  write_file(in_ + "/a.gltf", "no glTF");
  const CommandOutcome outcome = run({"compile", in_, "-o", out_, "--jobs", "1"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, testing::StartsWith(in_ + "/a.gltf: failed\n" + out_ + "/b/c.sinew: "));
  EXPECT_THAT(files_in(out_), ElementsAre("b/c.sinew"));
}

TEST_F(OutputFolder, two_inputs_of_one_output_are_wrong_usage_before_anything_is_written) {
  write_file(in_ + "/a.glb", tool_model());
  for (const char* command : {"compile", "sample"}) {
    const CommandOutcome outcome = run({command, in_, "-o", out_});
    EXPECT_EQ(outcome.status, 2) << command;
    EXPECT_THAT(outcome.err, HasSubstr("would be written for " + in_ + "/a.glb and for " + in_ + "/a.gltf"));
  }
  EXPECT_FALSE(fs::exists(out_));
  EXPECT_EQ(run_tool({"sample", in_ + "/a.gltf", in_ + "/b/c.gltf"}).status, 2) << "several need a folder";
  EXPECT_EQ(run_tool({"sample", in_ + "/a.gltf", "-", "-o", out_}).status, 2) << "- has no name";
}

TEST_F(OutputFolder, an_output_never_takes_the_place_of_any_input) {
  write_file(in_ + "/d.glb", tool_model());
  const std::string before = text_of_file(in_ + "/d.glb");
  const CommandOutcome same = run({"convert", in_, in_});
  EXPECT_EQ(same.status, 2);
  EXPECT_THAT(same.err, HasSubstr("d.glb is read; it is left as it is"));
  EXPECT_THAT(files_in(in_), ElementsAre("a.gltf", "b/c.gltf", "d.glb")) << "no other job has begun";
  fs::create_directory(out_);
  fs::create_hard_link(in_ + "/a.gltf", out_ + "/d.sinew");
  const CommandOutcome other = run({"compile", in_, "-o", out_});
  EXPECT_EQ(other.status, 2) << "the input of another job, by a hard link";
  EXPECT_THAT(other.err, HasSubstr("d.sinew is read; it is left as it is"));
  EXPECT_EQ(text_of_file(in_ + "/d.glb"), before);
  EXPECT_EQ(text_of_file(in_ + "/a.gltf"), tool_model());
}

TEST_F(OutputFolder, convert_reads_and_writes_the_standard_streams) {
  ASSERT_EQ(run_tool({"convert", in_ + "/a.gltf", place_.beside("a.glb")}).status, 0);
  const int before = dup(STDIN_FILENO);
  std::FILE* opened = std::fopen((in_ + "/a.gltf").c_str(), "rb");
  dup2(fileno(opened), STDIN_FILENO);
  const CommandOutcome outcome = run_tool({"convert", "-", "-"});
  dup2(before, STDIN_FILENO);
  close(before);
  std::fclose(opened);
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(outcome.out == text_of_file(place_.beside("a.glb"))) << "nothing but the .glb";
  EXPECT_THAT(outcome.err, HasSubstr("sinew: -: "));
  EXPECT_EQ(run_tool({"convert", in_ + "/a.gltf", "-", "--budget", "1mm"}).status, 2) << "it cannot be measured";
}

}  // namespace
}  // namespace sinew::test
