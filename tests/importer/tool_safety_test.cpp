// SPDX-License-Identifier: MIT
// No command harms the files or the terminal of its user, for any arguments and any model.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdio_ext.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <nlohmann/json.hpp>

#include "importer/tool/commands.h"
#include "importer/visible_text.h"
#include "tests/importer/tool_model.h"
#include "tests/support/file_text.h"
#include "tests/support/full_disk.h"

namespace sinew::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// Everything in the folder of the model, by name.
std::vector<std::string> names_beside(const ToolModelFile& model) {
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(fs::path(model.path()).parent_path()))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

TEST(tool_safety, an_output_appears_complete_or_not_at_all) {
  const ToolModelFile model;
  std::ofstream(model.beside("old.json")) << "old";
  ASSERT_EQ(run_tool({"sample", model.path(), "-o", model.beside("new.json.gz")}).status, 0);
  ASSERT_EQ(run_tool({"sample", model.path(), "-o", model.beside("old.json")}).status, 0);
  EXPECT_TRUE(nlohmann::json::accept(text_of_file(model.beside("old.json"))));
  fs::create_directory(model.beside("folder"));
  EXPECT_EQ(run_tool({"sample", model.path(), "-o", model.beside("folder")}).status, 2);
  EXPECT_EQ(run_tool({"sample", model.path(), "--clip", "none", "-o", model.beside("no folder/x.json")}).status, 2);
  EXPECT_THAT(names_beside(model), testing::ElementsAre("folder", "model.gltf", "new.json.gz", "old.json"));

  fs::create_symlink("old.json", model.beside("link.json"));
  ASSERT_EQ(run_tool({"sample", model.path(), "--clip", "none", "-o", model.beside("link.json")}).status, 0);
  EXPECT_TRUE(fs::is_symlink(model.beside("link.json"))) << "the file behind a link is replaced";
  EXPECT_EQ(nlohmann::json::parse(text_of_file(model.beside("old.json")))["clips"].size(), 1u);
}

TEST(tool_safety, an_output_that_does_not_fit_on_the_disk_leaves_nothing) {
  const ToolModelFile model;
  const std::string out = model.beside("poses.json");
  std::ofstream(out) << "old";
  CommandOutcome outcome;
  {
    const FullDisk disk(1000);
    outcome = run_tool({"sample", model.path(), "-o", out});
  }
  EXPECT_EQ(outcome.status, 3);
  EXPECT_EQ(outcome.err, "sinew: " + out + ": cannot be written to the end: File too large\n");
  EXPECT_EQ(text_of_file(out), "old");
  EXPECT_THAT(names_beside(model), testing::ElementsAre("model.gltf", "poses.json"));
}

/// Runs a command whose standard output is a device that takes no byte.
CommandOutcome run_with_full_stdout(const std::vector<std::string>& arguments) {
  setenv("SINEW_CACHE", "none", 0);
  std::vector<const char*> argv = {"sinew"};
  for (const std::string& argument : arguments) argv.push_back(argument.c_str());
  std::fflush(stdout);
  const int before = dup(STDOUT_FILENO), full = open("/dev/full", O_WRONLY | O_CLOEXEC);
  dup2(full, STDOUT_FILENO);
  close(full);
  testing::internal::CaptureStderr();
  CommandOutcome outcome;
  outcome.status = static_cast<int>(tool::run_command_line(static_cast<int>(argv.size()), argv.data()));
  outcome.err = testing::internal::GetCapturedStderr();
  __fpurge(stdout);
  std::clearerr(stdout);
  dup2(before, STDOUT_FILENO);
  close(before);
  return outcome;
}

TEST(tool_safety, a_standard_output_that_takes_nothing_is_told) {
  const ToolModelFile model;
  for (const char* command : {"info", "check", "plan"}) {
    const CommandOutcome outcome = run_with_full_stdout({command, model.path()});
    EXPECT_EQ(outcome.status, 3) << command;
    EXPECT_EQ(outcome.err, "sinew: stdout cannot be written\n") << command;
  }
  const CommandOutcome sampled = run_with_full_stdout({"sample", model.path()});
  EXPECT_EQ(sampled.status, 3);
  EXPECT_EQ(sampled.err, "sinew: stdout: cannot be written to the end: No space left on device\n");
}

TEST(tool_safety, pipes_and_devices_are_not_read) {
  const ToolModelFile model;
  const std::string pipe = model.beside("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  for (const char* command : {"info", "check", "sample", "plan"})
    for (const std::string& file : {pipe, std::string("/dev/zero")}) {
      EXPECT_EQ(run_tool({command, file}).status, 1) << command << ' ' << file;
    }
  const CommandOutcome verify = run_tool({"verify", model.path(), pipe});
  EXPECT_EQ(verify.status, 4);
  EXPECT_THAT(verify.err, HasSubstr("not a regular file"));
}

/// No byte that a terminal obeys, besides line ends.
bool is_plain(const std::string& text) {
  return std::all_of(text.begin(), text.end(),
                     [](char c) { return c == '\n' || static_cast<unsigned char>(c) >= 32; }) &&
         text.find('\x7f') == text.npos && text.find("\xc2\x9b") == text.npos && text.find("\xe2\x80\xae") == text.npos;
}

TEST(tool_safety, control_characters_of_a_file_reach_no_terminal) {
  const ToolModelFile model;
  const std::string odd = R"(\u001b[2J\u009b2J\u007f\u202e\n\r)";
  const std::string file = model.beside("odd.gltf");
  std::ofstream(file) << R"({"asset": {"version": "2.0", "generator": ")" + odd + R"(", "copyright": ")" + odd + R"("},
    "extensionsUsed": [")" + odd +
                             R"("], "nodes": [{"name": ")" + odd + R"(", "mesh": 0}, {"skin": 7}],
    "meshes": [{"name": ")" + odd +
                             R"(", "primitives": [{"attributes": {")" + odd + R"(": 9}}]}],
    "animations": [{"name": ")" +
                             odd + R"(", "samplers": [], "channels": []}],
    "images": [{"uri": ")" + odd +
                             R"("}], "buffers": [{"byteLength": 1, "uri": ")" + odd + R"("}]})";
  const std::string fine = model.beside("fine.gltf");
  std::ofstream(fine) << R"({"asset": {"version": "2.0", "generator": ")" + odd + R"(", "copyright": ")" + odd + R"("},
    "extensionsUsed": [")" + odd +
                             R"("], "nodes": [{"name": ")" + odd + R"("}], "materials": [{"name": ")" + odd + R"("}],
    "extensions": {"VRMC_vrm": {"specVersion": ")" +
                             odd + R"(", "meta": {"name": ")" + odd + R"("}}}})";
  for (const std::string& path : {file, fine})
    for (const auto& arguments : std::vector<std::vector<std::string>>{{"info", path},
                                                                       {"info", path, "--json"},
                                                                       {"check", path},
                                                                       {"check", path, "--json"},
                                                                       {"sample", path},
                                                                       {"plan", path},
                                                                       {"plan", path, "--json"}}) {
      const CommandOutcome outcome = run_tool(arguments);
      EXPECT_TRUE(is_plain(outcome.out)) << testing::PrintToString(arguments) << outcome.out;
      EXPECT_TRUE(is_plain(outcome.err)) << testing::PrintToString(arguments) << outcome.err;
    }
  const auto info = nlohmann::json::parse(run_tool({"info", fine, "--json"}).out);
  EXPECT_EQ(info["copyright"],
            "\x1b[2J\xc2\x9b"
            "2J\x7f\xe2\x80\xae\n\r")
      << "escaped in the text, whole in the value";
  EXPECT_THAT(run_tool({"info", fine}).out, HasSubstr(R"(copyright: \x1b[2J\u009b2J\x7f\u202e\x0a\x0d)"));
}

/// An archive that somebody unpacks may hold any names.
TEST(tool_safety, control_characters_in_names_of_files_and_folders_reach_no_terminal) {
  const ToolModelFile model;
  const std::string folder = model.beside("\x1b[2J"), odd = folder + "/\xc2\x9b.gltf", out = folder + "/out\x1b[2J";
  fs::create_directory(folder);
  fs::copy_file(model.path(), odd);
  const std::vector<std::vector<std::string>> lines = {{"info", odd},
                                                       {"check", folder},
                                                       {"sample", odd, "-o", out + ".json"},
                                                       {"verify", odd, out + ".json"},
                                                       {"convert", odd, out + ".glb"},
                                                       {"convert", folder, model.path(), out},
                                                       {"compile", odd, "-o", out + ".sinew"},
                                                       {"compile", folder, model.path(), "-o", out},
                                                       {"bake", odd, "--clip", "0", "-o", out + ".sgeo"},
                                                       {"verify", out + ".sgeo"}};
  for (const auto& line : lines) {
    const CommandOutcome outcome = run_tool(line);
    EXPECT_EQ(outcome.status, 0) << line[0] << outcome.err;
    EXPECT_TRUE(is_plain(outcome.out)) << line[0] << outcome.out;
    EXPECT_TRUE(is_plain(outcome.err)) << line[0] << outcome.err;
  }
}

}  // namespace
}  // namespace sinew::test
