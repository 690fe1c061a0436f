// SPDX-License-Identifier: MIT
// `sinew sample` and `sinew verify` from outside: what they leave unread, and what they print about a pose.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/importer/tool_model.h"

namespace sinew::test {
namespace {
using json = nlohmann::json;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

/// The model of tool_model.h after `change`.
template <class Change>
void rewrite(const ToolModelFile& model, const Change& change) {
  json file = json::parse(tool_model());
  change(file);
  std::ofstream(model.path(), std::ios::binary) << file;
}

/// Poses of a file of `sinew sample` after `change`.
template <class Change>
std::string changed_poses(const ToolModelFile& model, const std::string& golden, const Change& change) {
  json poses = json::parse(std::ifstream(golden));
  change(poses["clips"]);
  const std::string file = model.beside("changed.json");
  std::ofstream(file) << poses;
  return file;
}

TEST(pose_commands, commands_that_show_no_picture_do_not_miss_an_image) {
  const ToolModelFile model;
  const std::string golden = model.beside("golden.json");
  ASSERT_EQ(run_tool({"sample", model.path(), "-o", golden}).status, 0);
  rewrite(model, [](json& file) { file["images"] = json::array({{{"uri", "none.png"}}}); });
  for (const std::vector<std::string>& line : std::vector<std::vector<std::string>>{
           {"sample", model.path()},
           {"verify", model.path(), golden},
           {"plan", model.path()},
           {"info", model.path()},
           {"compile", model.path(), "-o", model.beside("out.sinew"), "--parts", "clips"},
           {"bake", model.path(), "--clip", "talk", "-o", model.beside("out.sgeo")}}) {
    const CommandOutcome outcome = run_tool(line);
    EXPECT_EQ(outcome.status, 0) << line[0] << outcome.err;
    EXPECT_THAT(outcome.err, Not(HasSubstr("image"))) << line[0];
  }
  EXPECT_THAT(run_tool({"check", model.path()}).out, HasSubstr("image-missing"));
}

TEST(pose_commands, G58_channels_of_default_weights_are_no_part_of_a_pose_file) {
  const ToolModelFile model;
  rewrite(model, [](json& file) {
    file["extensionsUsed"] = {"KHR_animation_pointer"};
    file["animations"][1]["channels"][0]["target"] = {
        {"path", "pointer"}, {"extensions", {{"KHR_animation_pointer", {{"pointer", "/meshes/1/weights"}}}}}};
  });
  const std::string golden = model.beside("golden.json");
  ASSERT_EQ(run_tool({"sample", model.path(), "--clip", "talk", "--times", "2", "-o", golden}).status, 0);
  const json pose = json::parse(std::ifstream(golden))["clips"][0]["samples"][0];
  EXPECT_EQ(pose["weights"][0]["weights"], (json{0.25, 0.0})) << "those of the mesh, which a node may replace";
  EXPECT_EQ(run_tool({"verify", model.path(), golden, "--exact"}).status, 0) << "and so does the command that compares";
}

TEST(pose_commands, times_are_those_of_the_rest_pose_too_where_it_is_named) {
  const ToolModelFile model;
  const auto times = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"sample", model.path(), "--times", "0.5,1.25"});
    const json poses = json::parse(run_tool(arguments).out);
    json out = json::array();
    for (const json& clip : poses["clips"])
      for (const json& sample : clip["samples"]) out.push_back({clip["clip"], sample["time"]});
    return out;
  };
  EXPECT_EQ(times({"--clip", "none"}), (json{{nullptr, 0.5}, {nullptr, 1.25}}));
  EXPECT_EQ(times({"--clip", "1"}), (json{{1, 0.5}, {1, 1.25}}));
  EXPECT_EQ(times({}), (json{{nullptr, 0.0}, {0, 0.5}, {0, 1.25}, {1, 0.5}, {1, 1.25}}));
}

TEST(pose_commands, verify_says_missing_of_what_the_model_no_longer_has) {
  const ToolModelFile model;
  const std::string golden = model.beside("golden.json");
  ASSERT_EQ(run_tool({"sample", model.path(), "--clip", "none", "-o", golden}).status, 0);
  const std::string more = changed_poses(model, golden, [](json& clips) {
    json node = clips[0]["samples"][0]["nodes"][0];
    node["node"] = 9;
    clips[0]["samples"][0]["nodes"].push_back(node);
  });
  const CommandOutcome outcome = run_tool({"verify", model.path(), more});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, HasSubstr("rest pose, 0 s, node 9, translation: missing\n"));
  EXPECT_THAT(outcome.out, Not(HasSubstr("off by inf"))) << "a distance that there is not";
}

TEST(pose_commands, verify_prints_how_far_a_value_is_off_and_how_far_it_may_be) {
  const ToolModelFile model;
  const std::string golden = model.beside("golden.json");
  ASSERT_EQ(run_tool({"sample", model.path(), "--clip", "none", "-o", golden}).status, 0);
  const std::string moved = changed_poses(model, golden, [](json& clips) {
    clips[0]["samples"][0]["nodes"][2]["world"][12] = 0.25;
    clips[0]["samples"][0]["weights"][0]["weights"][0] = 0.75;
  });
  const CommandOutcome outcome = run_tool({"verify", model.path(), moved, "--tolerance", "0.1"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, HasSubstr("largest distance 0.25 m, 2 out of tolerance"));
  EXPECT_THAT(outcome.out, HasSubstr("off by 0.25 m, allowed 0.1\n"));
  EXPECT_THAT(outcome.out, HasSubstr("off by 0.5, allowed 0.0001\n")) << "weights have no unit";
  EXPECT_EQ(run_tool({"verify", model.path(), golden}).status, 0);
  EXPECT_THAT(run_tool({"verify", model.path(), golden}).err, IsEmpty());
}

}  // namespace
}  // namespace sinew::test
