// SPDX-License-Identifier: MIT
// `sinew import` from outside: what it prints, writes and refuses.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "importer/import_gltf.h"
#include "tests/importer/tool_model.h"
#include "tests/support/file_text.h"

namespace sinew::test {
namespace {

using testing::HasSubstr;
using testing::IsEmpty;

constexpr const char* kSwing = R"(HIERARCHY
ROOT hip
{
  OFFSET 0 90 0
  CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation
  End Site
  {
    OFFSET 0 -40 0
  }
}
MOTION
Frames: 2
Frame Time: 0.5
0 90 0 0 0 0
10 90 0 90 0 0
)";

std::string written(const ToolModelFile& folder, const std::string& name, const std::string& text) {
  std::ofstream(folder.beside(name), std::ios::binary) << text;
  return folder.beside(name);
}

TEST(tool_import, bvh_becomes_a_glb_that_check_has_nothing_to_say_of) {
  const ToolModelFile folder;
  const std::string in = written(folder, "swing.bvh", kSwing), out = folder.beside("swing.glb");
  const CommandOutcome imported = run_tool({"import", in, out});
  EXPECT_EQ(imported.status, 0);
  EXPECT_THAT(imported.out, HasSubstr("BVH, 2 nodes, 1 clip of up to 2 keys and 0.5 s"));
  EXPECT_THAT(imported.err, HasSubstr("'hip' has an OFFSET and position channels; positions took its place"));
  EXPECT_EQ(run_tool({"check", "--strict", out}).status, 0);
  const auto file = import_gltf(out);
  ASSERT_TRUE(file);
  EXPECT_EQ(file->scene.animations.at(0).name, "swing");
  EXPECT_EQ(file->scene.animations[0].bones.at(0).translation.values.at(1), glm::vec3(0.1f, 0.9f, 0.0f));
}

TEST(tool_import, options_say_what_the_file_does_not) {
  const ToolModelFile folder;
  const std::string in = written(folder, "swing.bvh", kSwing), out = folder.beside("swing.glb");
  EXPECT_EQ(
      run_tool({"import", in, out, "--unit", "in", "--up", "z", "--positions", "add", "--end-sites", "drop"}).status,
      0);
  const auto file = import_gltf(out);
  ASSERT_TRUE(file);
  EXPECT_THAT(file->scene.skeleton.names, testing::ElementsAre("z_up", "hip"));
  EXPECT_NEAR(file->scene.animations.at(0).bones.at(0).translation.values.at(1).y, 180.0 * 0.0254, 1e-6);
  EXPECT_THAT(run_tool({"import", in, out, "--unit", "parsec"}).err, HasSubstr("m, dm, cm, mm, in, ft"));
  EXPECT_EQ(run_tool({"import", in, out, "--unit", "0"}).status, 2);
  EXPECT_EQ(run_tool({"import", in, out, "--unit", "1%"}).status, 2);
}

TEST(tool_import, a_fault_names_line_and_rule_and_leaves_the_old_output) {
  const ToolModelFile folder;
  const std::string in = written(folder, "bad.bvh", "HIERARCHY\nROOT a\n{\n  OFFSET 0 0,5 0\n");
  const std::string out = written(folder, "old.glb", "old");
  const CommandOutcome refused = run_tool({"import", in, out});
  EXPECT_EQ(refused.status, 1);
  EXPECT_THAT(refused.err, HasSubstr("bad.bvh: line 4: bvh-number: expected a number, found \"0,5\""));
  EXPECT_EQ(text_of_file(out), "old");
}

TEST(tool_import, other_kinds_of_files_get_a_sentence) {
  const ToolModelFile folder;
  const std::string out = folder.beside("out.glb");
  const struct {
    const char *text, *said;
  } cases[] = {{"o cube\nv 1 2 3\n", "Wavefront OBJ"},
               {"{\"asset\":{}}", "`sinew convert`"},
               {"", "empty"},
               {"<!doctype html>", "web page"},
               {"version https://git-lfs.github.com/spec/v1\n", "git lfs pull"}};
  for (const auto& c : cases) {
    const CommandOutcome refused = run_tool({"import", written(folder, "in", c.text), out});
    EXPECT_EQ(refused.status, 1) << c.said;
    EXPECT_THAT(refused.err, HasSubstr(c.said));
  }
  EXPECT_EQ(run_tool({"import", folder.beside("none.bvh"), out}).status, 1);
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(tool_import, other_commands_name_import) {
  const ToolModelFile folder;
  for (const char* text : {kSwing, "; FBX 7.4.0 project file\n", "Kaydara FBX Binary  ", "<?xml?>\n<COLLADA/>"})
    EXPECT_THAT(run_tool({"info", written(folder, "in", text)}).err, HasSubstr("`sinew import IN OUT.glb`"));
}

TEST(tool_import, a_folder_of_captures_becomes_a_folder_of_models) {
  const ToolModelFile folder;
  std::filesystem::create_directory(folder.beside("takes"));
  written(folder, "takes/walk.bvh", kSwing);
  written(folder, "takes/run.BVH", kSwing);
  written(folder, "takes/broken.bvh", "HIERARCHY");
  written(folder, "takes/notes.txt", "no motion");
  const CommandOutcome imported = run_tool({"import", folder.beside("takes"), folder.beside("out")});
  EXPECT_EQ(imported.status, 1);
  EXPECT_THAT(imported.out, HasSubstr("3 files: 2 done, 1 failed"));
  EXPECT_TRUE(std::filesystem::exists(folder.beside("out/walk.glb")));
  EXPECT_TRUE(std::filesystem::exists(folder.beside("out/run.glb")));
  EXPECT_FALSE(std::filesystem::exists(folder.beside("out/broken.glb")));
}

TEST(tool_import, the_output_is_a_glb_and_never_the_input) {
  const ToolModelFile folder;
  const std::string in = written(folder, "swing.glb", kSwing);
  EXPECT_EQ(run_tool({"import", in, in}).status, 2);
  EXPECT_EQ(text_of_file(in), kSwing);
  EXPECT_EQ(run_tool({"import", in, folder.beside("out.gltf")}).status, 2);
}

}  // namespace
}  // namespace sinew::test
