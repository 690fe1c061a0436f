// SPDX-License-Identifier: MIT
// `sinew sample` and `sinew verify` from outside: what they leave unread, and what they print about a pose.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/importer/tiny_gltf.h"
#include "tests/importer/tool_model.h"
#include "tests/support/file_text.h"

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

TEST(pose_commands, verify_names_clip_and_node_and_has_tolerances_for_each_kind) {
  const ToolModelFile model;
  const std::string golden = model.beside("golden.json");
  ASSERT_EQ(run_tool({"sample", model.path(), "--clip", "bend", "-o", golden}).status, 0);
  const std::string moved = changed_poses(model, golden, [](json& clips) {
    json& sample = clips[0]["samples"][0];
    sample["nodes"][2]["world"][12] = 0.25;
    sample["skinned"][0]["normals"][0] = {0.99, 0.141, 0.0};  // 8 degrees
  });
  const CommandOutcome outcome = run_tool({"verify", model.path(), moved, "--tolerance", "0.1"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, HasSubstr("clip 0 \"bend\", 0 s, node 2 \"tip\", translation: off by 0.25 m"));
  EXPECT_THAT(outcome.out, HasSubstr(" deg, allowed 0.0573"));
  const auto status = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"verify", model.path(), moved, "--tolerance", "1"});
    return run_tool(more).status;
  };
  EXPECT_EQ(status({"--tolerance-normals", "5deg"}), 1);
  EXPECT_EQ(status({"--tolerance-normals", "10deg"}), 0);
  EXPECT_EQ(status({"--tolerance-normals", "1mm"}), 2);
  EXPECT_EQ(status({"--tolerance-weights", "some"}), 2);
  EXPECT_EQ(status({"--tolerance-normals", "10deg", "--tolerance-matrices", "0.1%"}), 0);
}

TEST(pose_commands, verify_update_writes_the_poses_as_they_are_now) {
  const ToolModelFile model;
  const std::string golden = model.beside("golden.json");
  ASSERT_EQ(run_tool({"sample", model.path(), "-o", golden}).status, 0);
  const std::string as_sampled = text_of_file(golden);
  EXPECT_EQ(run_tool({"verify", model.path(), golden, "--update"}).status, 0);
  EXPECT_EQ(text_of_file(golden), as_sampled) << "nothing moved";
  const std::string moved =
      changed_poses(model, golden, [](json& clips) { clips[1]["samples"][0]["nodes"][2]["world"][12] = 0.25; });
  const CommandOutcome outcome = run_tool({"verify", model.path(), moved, "--update"});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("off by 0.25 m"));
  EXPECT_THAT(outcome.out, HasSubstr(": updated"));
  EXPECT_EQ(run_tool({"verify", model.path(), moved, "--exact"}).status, 0);
  EXPECT_EQ(json::parse(text_of_file(moved))["clips"], json::parse(as_sampled)["clips"]);
}

TEST(pose_commands, verify_says_that_vertices_were_merged_or_renumbered) {
  const ToolModelFile model;
  TinyGltf gltf;
  std::vector<float> corners;
  for (int x = 0; x < 12; ++x)
    for (const auto& [i, j] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 0}, {1, 1}, {0, 1}}) {
      const float u = static_cast<float>(x + i), v = static_cast<float>(j);
      corners.insert(corners.end(), {u, v, 0.1f * u * u});
    }
  gltf.add_triangle();
  const std::size_t positions = gltf.vec3(corners);
  gltf.root["accessors"][positions]["min"] = {0, 0, 0};
  gltf.root["accessors"][positions]["max"] = {12, 1, 14.4};
  gltf.root["meshes"][0]["primitives"][0]["attributes"]["POSITION"] = positions;
  gltf.root["nodes"] = Json::array({{{"mesh", 0}, {"name", "strip"}}});
  const std::string in = model.beside("strip.gltf"), out = model.beside("merged.glb"),
                    golden = model.beside("strip.json");
  std::ofstream(in) << gltf.text();
  ASSERT_EQ(run_tool({"sample", in, "-o", golden}).status, 0);
  ASSERT_EQ(run_tool({"convert", in, out, "--quantize"}).status, 0);
  EXPECT_EQ(run_tool({"verify", out, golden}).status, 0) << "order and number stay";
  ASSERT_EQ(run_tool({"convert", in, out, "--merge-vertices"}).status, 0);
  const CommandOutcome outcome = run_tool({"verify", out, golden});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.out, HasSubstr("have other numbers, or were merged"));
  EXPECT_THAT(outcome.out, HasSubstr("largest distance 0 m, 1 out of tolerance"));
}

TEST(pose_commands, verify_takes_shares_of_the_joints_where_there_are_no_meshes) {
  const ToolModelFile model;
  TinyGltf gltf;
  gltf.root["nodes"] = Json::array({{{"children", {1}}}, {{"translation", {0, 0.8, 0}}}});
  gltf.animate("translation", gltf.times({0, 1}), gltf.vec3({0, 0, 0, 0.1f, 0, 0}));
  const std::string in = model.beside("joints.gltf"), golden = model.beside("joints.json");
  std::ofstream(in) << gltf.text();
  ASSERT_EQ(run_tool({"sample", in, "-o", golden}).status, 0);
  json poses = json::parse(text_of_file(golden));
  EXPECT_NEAR(poses["extent"].get<double>(), 0.8, 1e-6);
  for (const double extent : {0.8, 1e-9}) {  // an earlier version wrote the latter
    poses["extent"] = extent;
    json moved = poses;
    json& x = moved["clips"][0]["samples"][0]["nodes"][0]["world"][12];
    x = x.get<double>() + 0.006;
    std::ofstream(golden) << moved;
    EXPECT_EQ(run_tool({"verify", in, golden, "--tolerance", "1%"}).status, 0) << extent;
    EXPECT_EQ(run_tool({"verify", in, golden, "--tolerance", "0.5%"}).status, 1) << extent;
  }
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

TEST(tool_verify, a_test_report_has_a_case_for_each_file) {
  const ToolModelFile model;
  const std::string golden = model.beside("golden.json"), report = model.beside("report.xml");
  ASSERT_EQ(run_tool({"sample", model.path(), "-o", golden}).status, 0);
  const auto reported = [&](const std::string& poses) {
    const CommandOutcome outcome = run_tool({"verify", model.path(), poses, "--junit", report});
    std::ifstream file(report);
    return std::pair(outcome.status, std::string(std::istreambuf_iterator<char>(file), {}));
  };
  const auto [held, passed] = reported(golden);
  EXPECT_EQ(held, 0);
  EXPECT_THAT(passed, HasSubstr("<testsuite name=\"sinew verify\" tests=\"1\" failures=\"0\" errors=\"0\""));
  EXPECT_THAT(passed, HasSubstr("name=\"" + model.path() + "\""));

  std::ifstream from(golden);
  std::string text(std::istreambuf_iterator<char>(from), {});
  const std::string world = "\"world\": [1";
  const std::size_t at = text.find(world);
  ASSERT_NE(at, std::string::npos);
  text.replace(at, world.size(), "\"world\": [2");
  std::ofstream(model.beside("moved & <new>.json")) << text;
  const auto [moved, failed] = reported(model.beside("moved & <new>.json"));
  EXPECT_EQ(moved, 1);
  EXPECT_THAT(failed, HasSubstr("failures=\"1\" errors=\"0\""));
  EXPECT_THAT(failed, HasSubstr("moved &amp; &lt;new&gt;.json"));
  EXPECT_THAT(failed, HasSubstr("<failure message=\""));
  EXPECT_THAT(failed, HasSubstr("off by"));

  const auto [missing, error] = reported(model.beside("none.json"));
  EXPECT_EQ(missing, 4);
  EXPECT_THAT(error, HasSubstr("failures=\"0\" errors=\"1\""));
  EXPECT_EQ(run_tool({"verify", model.path(), golden, "--junit", model.beside("no/folder.xml")}).status, 2);
}

}  // namespace
}  // namespace sinew::test
