// SPDX-License-Identifier: MIT
// What `sinew cost` refuses before it measures anything.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "tests/importer/tool_model.h"

namespace sinew::test {
namespace {
namespace fs = std::filesystem;
using testing::HasSubstr;

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(cost_command, refuses_a_clip_of_what_has_none) {
  const ToolModelFile model;
  const std::string cache = model.beside("talk.sgeo"), folder = model.beside("costs");
  EXPECT_EQ(run_tool({"cost", "-o", folder, "--clip", "0"}).err,
            "sinew: --clip: names a clip of FILE, and there is no FILE\n");
  ASSERT_EQ(run_tool({"bake", model.path(), "--clip", "talk", "-o", cache}).status, 0);
  const CommandOutcome outcome = run_tool({"cost", cache, "-o", folder, "--clip", "0"});
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.err, "sinew: --clip: names a clip of a glTF file, and FILE is none\n");
}

TEST(cost_command, refuses_a_folder_that_holds_other_things) {
  const ToolModelFile model;
  const fs::path other = model.beside("photos");
  fs::create_directory(other);
  std::ofstream(other / "cat.jpg") << "meow";
  const CommandOutcome refused = run_tool({"cost", model.path(), "--quick", "-o", other.string()});
  EXPECT_EQ(refused.status, 2);
  EXPECT_THAT(refused.err, HasSubstr("cat.jpg"));
  EXPECT_EQ(text_of(other / "cat.jpg"), "meow");
}

TEST(cost_command, leaves_no_folder_behind_for_a_broken_file) {
  const ToolModelFile model;
  const fs::path broken = model.beside("broken.gltf"), out = model.beside("none");
  std::ofstream(broken) << "{\"asset\": {";
  EXPECT_EQ(run_tool({"cost", broken.string(), "-o", out.string()}).status, 1);
  EXPECT_FALSE(fs::exists(out));
}

TEST(cost_command, refuses_wrong_usage_before_any_work) {
  const ToolModelFile model;
  EXPECT_EQ(run_tool({"cost", model.path()}).status, 2);
  EXPECT_EQ(run_tool({"cost", model.path(), "-o", model.beside("no/such/folder")}).status, 2);
  EXPECT_EQ(run_tool({"cost", model.path(), "--clip", "nobody", "-o", model.beside("x")}).status, 2);
  EXPECT_EQ(run_tool({"cost", "--clip", "0", "-o", model.beside("x")}).status, 2);
}

}  // namespace
}  // namespace sinew::test
