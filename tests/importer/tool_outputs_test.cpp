// SPDX-License-Identifier: MIT
// No command writes over a file that it reads, by whatever path or link.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <thread>

#include "tests/importer/tool_model.h"
#include "tests/support/file_text.h"

namespace sinew::test {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// The arguments that make a command read `in` and write `out`.
using Command = std::vector<std::string> (*)(const std::string& in, const std::string& out);
const std::map<std::string, Command> kWriting = {
    {"sample",
     [](const auto& in, const auto& out) {
       return std::vector<std::string>{"sample", in, "-o", out};
     }},
    {"compile",
     [](const auto& in, const auto& out) {
       return std::vector<std::string>{"compile", in, "-o", out};
     }},
    {"bake",
     [](const auto& in, const auto& out) {
       return std::vector<std::string>{"bake", in, "-o", out};
     }},
    {"bake-ao",
     [](const auto& in, const auto& out) {
       return std::vector<std::string>{"bake-ao", in, "-o", out};
     }},
    {"convert",
     [](const auto& in, const auto& out) {
       return std::vector<std::string>{"convert", in, out};
     }},
    {"import",
     [](const auto& in, const auto& out) {
       const std::string motion = (fs::path(in).parent_path() / "motion.bvh").string();
       std::ofstream(motion) << "HIERARCHY ROOT a { OFFSET 0 0 0 } MOTION Frames: 0 Frame Time: 0";
       return std::vector<std::string>{"import", motion, out};
     }},
    {"retarget",
     [](const auto& in, const auto& out) { return std::vector<std::string>{"retarget", in, "--onto", in, "-o", out}; }},
    {"simulate",
     [](const auto& in, const auto& out) {
       return std::vector<std::string>{"simulate", in, "-o", out};
     }},
    {"cost",
     [](const auto& in, const auto& out) {
       return std::vector<std::string>{"cost", in, "--quick", "-o", fs::path(out).parent_path().string()};
     }},
};

/// Commands whose outputs have tests elsewhere. `batch` fills a folder (tool_batch_test.cpp); a golden trace of `graph`
/// names its graph as seen from its own place (tool_graph_test.cpp).
const std::set<std::string> kTestedElsewhere = {"batch", "graph"};

/// The names of all commands, as the help lists them: two spaces, the name, two spaces.
std::vector<std::string> commands_of_help() {
  std::vector<std::string> names;
  std::istringstream help(run_tool({"--help"}).out);
  bool listed = false;
  for (std::string line; std::getline(help, line);) {
    if (line.starts_with("Subcommands:") || line.starts_with("Commands:")) listed = true;
    const bool names_one = listed && line.starts_with("  ") && line.size() > 2 && line[2] != ' ';
    if (names_one) names.push_back(line.substr(2, line.find(' ', 2) - 2));
  }
  return names;
}

bool writes(const std::string& help) {
  return help.find("--output") != std::string::npos || help.find("  OUT ") != std::string::npos;
}

TEST(tool_outputs, every_command_that_writes_is_in_the_tests_below) {
  const std::vector<std::string> commands = commands_of_help();
  ASSERT_GE(commands.size(), 8u);
  for (const std::string& command : commands)
    EXPECT_EQ(writes(run_tool({command, "--help"}).out),
              kWriting.contains(command) || kTestedElsewhere.contains(command))
        << command;
}

/// Runs every command that writes, and expects that it leaves `in` and `out` as they are.
void expect_refused(const std::string& in, const std::string& out, const std::vector<std::string>& commands) {
  const std::string before = text_of_file(out), before_in = text_of_file(in);
  const std::vector<std::string> there = commands_of_help();
  for (const std::string& command : commands) {
    if (std::find(there.begin(), there.end(), command) == there.end()) continue;  // a build without `sinew cost`
    const CommandOutcome outcome = run_tool(kWriting.at(command)(in, out));
    EXPECT_EQ(outcome.status, 2) << command << ' ' << in << ' ' << out;
    EXPECT_THAT(outcome.err, HasSubstr(out + " is read; it is left as it is")) << command;
    EXPECT_EQ(text_of_file(out), before) << command;
    EXPECT_EQ(text_of_file(in), before_in) << command;
  }
}

TEST(tool_outputs, an_output_never_takes_the_place_of_an_input) {
  const ToolModelFile model;
  fs::create_symlink("model.gltf", model.beside("symbolic.gltf"));
  fs::create_hard_link(model.path(), model.beside("hard.gltf"));
  for (const std::string& out :
       {model.path(), model.beside("./model.gltf"), model.beside("symbolic.gltf"), model.beside("hard.gltf")})
    expect_refused(model.path(), out, {"sample", "compile", "bake", "bake-ao", "convert", "retarget", "simulate"});
  const auto left = fs::directory_iterator(fs::path(model.path()).parent_path());
  EXPECT_EQ(std::distance(left, fs::directory_iterator()), 3) << "nothing else was written";
}

TEST(tool_outputs, what_is_no_file_is_never_replaced_by_one) {
  const ToolModelFile model;
  const std::string taken = model.beside("taken.glb");
  fs::create_directory(taken);
  for (const std::string& command : commands_of_help()) {
    if (!kWriting.contains(command) || command == "cost") continue;  // which writes a folder
    const CommandOutcome outcome = run_tool(kWriting.at(command)(model.path(), taken));
    EXPECT_EQ(outcome.status, 2) << command;
    EXPECT_THAT(outcome.err, HasSubstr(taken + " exists and is not a regular file")) << command;
    EXPECT_TRUE(fs::is_directory(taken)) << command;
  }
}

/// The commands that write one output, and those of them that this build has.
std::vector<std::string> commands_of_one_output() {
  std::vector<std::string> names;
  for (const std::string& command : commands_of_help())
    if (kWriting.contains(command) && command != "cost") names.push_back(command);
  return names;
}

/// A hair of one joint, for `simulate`.
constexpr const char* kHair = R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0]}],
  "nodes": [{"children": [1]}, {"translation": [0, 1, 0]}], "extensionsUsed": ["VRMC_springBone"],
  "extensions": {"VRMC_springBone": {"specVersion": "1.0", "springs": [{"joints": [{"node": 0}, {"node": 1}]}]}}})";

/// Runs a command on the model, or on the hair. `bake` needs to know which of the clips.
CommandOutcome run_writing(const std::string& command, const ToolModelFile& model, const std::string& out) {
  const std::string in = command == "simulate" ? model.beside("hair.gltf") : model.path();
  if (command == "simulate") write_file(in, kHair);
  std::vector<std::string> arguments = kWriting.at(command)(in, out);
  if (command == "bake") arguments.insert(arguments.end(), {"--clip", "0"});
  return run_tool(arguments);
}

/// The bytes that a command writes to a regular file. Its name has the extension that each command wants.
std::string bytes_in_a_file(const ToolModelFile& model, const std::string& command) {
  const std::string out = model.beside(command == "sample" ? "file.json" : "file.glb");
  EXPECT_EQ(run_writing(command, model, out).status, 0) << command;
  const std::string bytes = text_of_file(out);
  fs::remove(out);
  return bytes;
}

TEST(tool_outputs, a_device_is_written_and_stays_a_device) {
  const ToolModelFile model;
  for (const std::string& command : commands_of_one_output()) {
    const CommandOutcome outcome = run_writing(command, model, "/dev/null");
    EXPECT_EQ(outcome.status, 0) << command << ": " << outcome.err;
    EXPECT_TRUE(fs::is_character_file("/dev/null")) << command;
  }
}

TEST(tool_outputs, every_command_tells_of_an_output_that_takes_nothing) {
  const ToolModelFile model;
  for (const std::string& command : commands_of_one_output()) {
    const CommandOutcome outcome = run_writing(command, model, "/dev/full");
    EXPECT_EQ(outcome.status, 3) << command;
    EXPECT_THAT(outcome.err, HasSubstr("/dev/full")) << command;
  }
}

TEST(tool_outputs, a_pipe_gets_the_bytes_of_a_file) {
  const ToolModelFile model;
  const std::string pipe = model.beside("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  for (const std::string& command : commands_of_one_output()) {
    std::string read;
    std::thread reader([&] { read = text_of_file(pipe); });
    const CommandOutcome outcome = run_writing(command, model, pipe);
    // A command that fails before it opens the pipe would leave the reader waiting.
    if (outcome.status != 0) std::ofstream(pipe).close();
    reader.join();
    EXPECT_EQ(outcome.status, 0) << command << ": " << outcome.err;
    EXPECT_EQ(read, bytes_in_a_file(model, command)) << command;
    EXPECT_TRUE(fs::is_fifo(pipe)) << command;
  }
}

TEST(tool_outputs, the_standard_output_gets_the_bytes_alone) {
  const ToolModelFile model;
  for (const std::string& command : commands_of_one_output())
    for (const char* name : {"-", "/dev/stdout"}) {
      const CommandOutcome outcome = run_writing(command, model, name);
      EXPECT_EQ(outcome.status, 0) << command << ' ' << name << ": " << outcome.err;
      EXPECT_EQ(outcome.out, bytes_in_a_file(model, command)) << command << ' ' << name;
    }
  EXPECT_FALSE(fs::exists("-"));
}

TEST(tool_outputs, buffers_and_images_of_a_file_are_inputs_too) {
  const ToolModelFile model;
  const std::string in = model.beside("other.gltf");
  std::ofstream(model.beside("data.bin")) << std::string(36, '\0');
  std::ofstream(model.beside("picture.png")) << "no picture";
  std::ofstream(in) << R"({"asset": {"version": "2.0"}, "nodes": [{}], "images": [{"uri": "picture.png"}],
                           "buffers": [{"byteLength": 36, "uri": "data.bin"}]})";
  for (const char* out : {"data.bin", "picture.png"})
    expect_refused(in, model.beside(out), {"sample", "compile", "bake"});
  fs::create_symlink("data.bin", model.beside("data.glb"));
  fs::create_symlink("data.bin", model.beside("new.bin"));
  expect_refused(in, model.beside("data.glb"), {"convert", "bake-ao"});
  const CommandOutcome beside = run_tool({"convert", in, model.beside("new.gltf")});
  EXPECT_EQ(beside.status, 2);
  EXPECT_THAT(beside.err, HasSubstr("new.bin is read; it is left as it is")) << "the buffer beside a .gltf";
}

TEST(tool_outputs, a_report_replaces_no_file_that_it_is_about) {
  const ToolModelFile model;
  fs::create_directory(model.beside("report"));
  const std::string in = model.beside("report/report.json");
  fs::copy_file(model.path(), in);
  expect_refused(in, in, {"cost"});
  const std::string text = model.beside("named.gltf");
  std::ofstream(text) << R"({"asset": {"version": "2.0"}, "nodes": [{}],
                             "buffers": [{"byteLength": 4, "uri": "report/report.json"}]})";
  expect_refused(text, in, {"cost"});
}

TEST(tool_outputs, every_numbered_file_and_every_point_cache_is_an_input) {
  const ToolModelFile model;
  const char* const obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  for (const char* name : {"cloth_1.obj", "cloth_2.obj", "cloth_3.obj"}) std::ofstream(model.beside(name)) << obj;
  for (const char* name : {"cloth_1.obj", "cloth_2.obj", "cloth_3.obj"})
    expect_refused(model.beside("cloth_1.obj"), model.beside(name), {"bake"});
  EXPECT_EQ(run_tool({"bake", model.beside("cloth_2.obj"), "-o", model.beside("cloth_1.obj")}).status, 0)
      << "a frame before the first one is not read";
  std::ofstream(model.beside("moved.mdd")) << "points";
  for (const std::string& in : {model.beside("cloth_2.obj"), model.path()}) {
    const CommandOutcome outcome =
        run_tool({"bake", in, "--points", model.beside("moved.mdd"), "-o", model.beside("moved.mdd")});
    EXPECT_EQ(outcome.status, 2) << in;
    EXPECT_THAT(outcome.err, HasSubstr("moved.mdd is read; it is left as it is")) << in;
  }
}

}  // namespace
}  // namespace sinew::test
