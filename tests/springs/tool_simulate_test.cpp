// SPDX-License-Identifier: MIT
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "tests/importer/tiny_gltf.h"
#include "tests/importer/tool_model.h"
#include "tests/springs/spring_stage.h"
#include "tests/support/corpus.h"
#include "tests/support/file_text.h"
#include "tests/support/json.h"

namespace sinew::test {
namespace {

using testing::HasSubstr;
using Vec = Vec3<double>;

/// A hair of three bones of half a metre below a head, and a clip of one second that turns the head.
std::string hair() {
  TinyGltf file;
  file.root["nodes"] = Json::parse(R"([{"name": "head", "children": [1]},
    {"name": "a", "children": [2], "translation": [0, -0.5, 0]}, {"name": "b", "children": [3], "translation": [0, -0.5, 0]},
    {"name": "c", "children": [4], "translation": [0, -0.5, 0]}, {"name": "end", "translation": [0, -0.5, 0]}])");
  file.root["scenes"] = Json::parse(R"([{"nodes": [0]}])");
  file.animate("rotation", file.times({0, 1}), file.vec4({0, 0, 0, 1, 0, 0, 1, 0}));
  file.root["animations"][0]["name"] = "nod";
  file.root["extensionsUsed"] = {"VRMC_springBone"};
  file.root["extensions"]["VRMC_springBone"] = Json::parse(R"({"specVersion": "1.0", "springs": [{"joints": [
    {"node": 1, "dragForce": 0.4}, {"node": 2, "dragForce": 0.4}, {"node": 3, "dragForce": 0.4}, {"node": 4}]}]})");
  return file.text();
}

class ToolSimulate : public testing::Test {
 protected:
  ToolSimulate() { write_file(path("hair.gltf"), hair()); }

  std::string path(const std::string& name) const { return folder_.beside(name); }

  CommandOutcome simulate(std::vector<std::string> options) {
    options.insert(options.begin(), {"simulate", path("hair.gltf"), "-o", path("out.json")});
    return run_tool(options);
  }
  Json result() const { return Json::parse(text_of_file(path("out.json"))); }

 private:
  ToolModelFile folder_;
};

TEST_F(ToolSimulate, writes_rotations_and_tails_of_every_frame) {
  const CommandOutcome outcome = simulate({"--fps", "30", "--for", "0.5"});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("15 frames of 3 joints"));
  const Json run = result();
  EXPECT_EQ(run["file"], "hair.gltf");
  EXPECT_EQ(run["fps"], 30);
  EXPECT_EQ(run["joints"], Json::parse(R"(["a", "b", "c"])"));
  ASSERT_EQ(run["frames"].size(), 15u);
  const Json& frame = run["frames"][14];
  EXPECT_EQ(frame["t"], 0.5);
  EXPECT_EQ(frame["q"], Json::parse("[[0, 0, 0, 1], [0, 0, 0, 1], [0, 0, 0, 1]]")) << "it hangs still";
  EXPECT_NEAR(frame["tail"][2][1].get<double>(), -2.0, 1e-9);
}

TEST_F(ToolSimulate, a_path_moves_the_root_and_a_clip_the_head) {
  write_file(path("path.json"), R"({"times": [0, 1], "translations": [[0, 0, 0], [4, 0, 0]]})");
  ASSERT_EQ(simulate({"--for", "1", "--root", path("path.json")}).status, 0);
  const Json moved = result();
  EXPECT_GT(moved["frames"][59]["tail"][2][0].get<double>(), 2.0);
  EXPECT_LT(moved["frames"][59]["tail"][2][0].get<double>(), 3.9) << "it lags";
  ASSERT_EQ(simulate({"--for", "0.5", "--clip", "nod"}).status, 0);
  const Json turned = result();
  EXPECT_GT(std::abs(turned["frames"][29]["tail"][2][0].get<double>()), 0.2);
}

/// A head with two eyes that turn by up to 12 degrees, without springs.
std::string face(const char* kind) {
  TinyGltf file;
  file.root["nodes"] = Json::parse(R"([{"name": "head", "children": [1, 2], "translation": [0, 1.5, 0]},
    {"name": "l", "translation": [0.03, 0.05, 0.08]}, {"name": "r", "translation": [-0.03, 0.05, 0.08]}])");
  file.root["scenes"] = Json::parse(R"([{"nodes": [0]}])");
  file.root["extensionsUsed"] = {"VRMC_vrm"};
  file.root["extensions"]["VRMC_vrm"] = Json::parse(R"({"specVersion": "1.0",
    "humanoid": {"humanBones": {"head": {"node": 0}, "leftEye": {"node": 1}, "rightEye": {"node": 2}}},
    "lookAt": {"offsetFromHeadBone": [0, 0.05, 0.08],
               "rangeMapHorizontalInner": {"inputMaxValue": 90, "outputScale": 9},
               "rangeMapHorizontalOuter": {"inputMaxValue": 90, "outputScale": 12}}})");
  file.root["extensions"]["VRMC_vrm"]["lookAt"]["type"] = kind;
  return file.text();
}

TEST_F(ToolSimulate, eyes_look_at_a_place_in_the_world) {
  write_file(path("face.gltf"), face("bone"));
  write_file(path("path.json"), R"({"times": [0], "translations": [[5, 0, 0]]})");
  const std::vector<std::string> look{"simulate", path("face.gltf"), "-o",        path("out.json"), "--for", "0.1",
                                      "--root",   path("path.json"), "--look-at", "7,1.55,2.08"};  // 45 degrees left
  const CommandOutcome outcome = run_tool(look);
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  const Json bones = result();
  EXPECT_EQ(bones["joints"], Json::parse(R"(["l", "r"])"));
  const Json& frame = bones["frames"].back();
  const double half = std::numbers::pi / 360.0;
  EXPECT_NEAR(frame["gaze"]["yaw"].get<double>(), std::numbers::pi / 4.0, 1e-6);
  EXPECT_NEAR(frame["q"][0][1].get<double>(), std::sin(6.0 * half), 1e-6) << "outer: half of 12 degrees";
  EXPECT_NEAR(frame["q"][1][1].get<double>(), std::sin(4.5 * half), 1e-6) << "inner: half of 9 degrees";
  write_file(path("face.gltf"), face("expression"));
  ASSERT_EQ(run_tool(look).status, 0);
  EXPECT_NEAR(result()["frames"].back()["gaze"]["left"].get<double>(), 6.0, 1e-5) << "the file says 12";
  EXPECT_EQ(result()["frames"].back()["gaze"]["right"], 0.0);
}

/// Two legs with slightly bent knees, without VRM data. The left foot is at x = 0.1.
std::string legs() {
  TinyGltf file;
  file.root["nodes"] = Json::parse(R"([{"name": "Hips", "children": [1, 4], "translation": [0, 0.9, 0]},
    {"name": "LeftUpLeg", "children": [2], "translation": [0.1, 0, 0]},
    {"name": "LeftLeg", "children": [3], "translation": [0, -0.42, 0.05]},
    {"name": "LeftFoot", "translation": [0, -0.4, -0.05]},
    {"name": "RightUpLeg", "children": [5], "translation": [-0.1, 0, 0]},
    {"name": "RightLeg", "children": [6], "translation": [0, -0.42, 0.05]},
    {"name": "RightFoot", "translation": [0, -0.4, -0.05]}])");
  file.root["scenes"] = Json::parse(R"([{"nodes": [0]}])");
  return file.text();
}

class ToolSimulateFeet : public ToolSimulate {
 protected:
  ToolSimulateFeet() { write_file(path("legs.gltf"), legs()); }

  CommandOutcome stand(const std::string& ground, double z = 0.0) {
    write_file(path("path.json"), Json{{"times", {0}}, {"translations", {{0, 0, z}}}}.dump());
    return run_tool({"simulate", path("legs.gltf"), "-o", path("out.json"), "--for", "2", "--ground", ground, "--root",
                     path("path.json")});
  }

  /// Heights of the left and the right ankle after two seconds.
  std::pair<double, double> ankles(const std::string& ground, double z = 0.0) {
    const CommandOutcome outcome = stand(ground, z);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    const Json frame = result()["frames"].back();
    for (const Json& foot : frame["feet"]) {
      EXPECT_NEAR(foot["tip"].get<double>(), 0.0, 2e-3) << ground;
      EXPECT_EQ(foot["locked"], true) << ground;
    }
    return {frame["tail"][3][1].get<double>(), frame["tail"][6][1].get<double>()};
  }
};

TEST_F(ToolSimulateFeet, stand_on_flat_ground_slopes_and_steps) {
  const auto near = [](double left, double right) {
    return testing::Pair(testing::DoubleNear(left, 2e-3), testing::DoubleNear(right, 2e-3));
  };
  EXPECT_THAT(ankles("0"), near(0.08, 0.08));
  EXPECT_EQ(result()["joints"],
            Json::parse(R"(["Hips", "LeftUpLeg", "LeftLeg", "LeftFoot", "RightUpLeg", "RightLeg", "RightFoot"])"));
  EXPECT_THAT(ankles("-3"), near(-2.92, -2.92));
  EXPECT_THAT(ankles("steps=0.2x0.4", 0.6), near(0.28, 0.28)) << "on the first step";
  EXPECT_THAT(ankles("slope=-20", 1.0).first, testing::DoubleNear(0.08 - std::tan(std::numbers::pi / 9.0), 0.01));
  write_file(path("ground.json"), R"({"distances": [-1, 0], "heights": [0, 0.12], "direction": [2, 0]})");
  EXPECT_THAT(ankles(path("ground.json")), near(0.2, 0.08));
  write_file(path("ground.json"),
             R"({"distances": [-1, 1], "heights": [-0.5, 0.5], "steps": false, "direction": [1, 0]})");
  const double across = 0.05 + 0.08 * std::cos(std::atan(0.5));  // soles turn with the slope
  EXPECT_THAT(ankles(path("ground.json")), near(across, across - 0.1));
}

TEST_F(ToolSimulateFeet, says_what_is_wrong_with_the_ground) {
  const auto expect = [&](const std::string& ground, const char* text) {
    const CommandOutcome outcome = stand(ground);
    EXPECT_EQ(outcome.status, 1) << ground;
    EXPECT_THAT(outcome.err, HasSubstr(text));
  };
  for (const char* text : {"nan", "1e9", "slope=90", "slope=", "steps=0.2", "steps=0.2x0", "steps=0.2x-1", "1,2"})
    expect(text, "is neither a height, slope=DEGREES, steps=RISExTREAD nor a file");
  const std::pair<const char*, const char*> files[] = {
      {"[]", "is no JSON of the form"},
      {R"({"distances": [0, "a"], "heights": [0, 1]})", "is no JSON of the form"},
      {R"({"distances": [], "heights": []})", "/distances: is empty"},
      {R"({"distances": [0, 1], "heights": [0]})", "/heights: has 1 entries for 2 distances"},
      {R"({"distances": [0, 0], "heights": [0, 1]})", "/distances/1: is not beyond the distance before"},
      {R"({"distances": [0], "heights": [0], "steps": 1})", "/steps: is neither true nor false"},
      {R"({"distances": [0], "heights": [0], "direction": [1, 0, 0]})", "/direction: is no list of two numbers"},
      {R"({"distances": [0], "heights": [0], "direction": [0, 0]})", "/direction: has no length"}};
  for (const auto& [content, text] : files) {
    write_file(path("ground.json"), content);
    expect(path("ground.json"), text);
  }
  const CommandOutcome hair = simulate({"--ground", "0"});
  EXPECT_EQ(hair.status, 1);
  EXPECT_THAT(hair.err, HasSubstr("hair.gltf: it has no left leg from hips to foot"));
}

TEST_F(ToolSimulate, one_frame_rate_is_like_another) {
  write_file(path("path.json"),
             R"({"times": [0, 0.25, 0.5, 1], "translations": [[0,0,0], [0.5,0,0], [0,0.2,0], [0,0,1]]})");
  std::vector<Vec> ends;
  for (const char* fps : {"60", "30", "120", "144"}) {
    ASSERT_EQ(simulate({"--fps", fps, "--for", "1", "--root", path("path.json")}).status, 0);
    const Json tail = result()["frames"].back()["tail"][2];
    ends.emplace_back(tail[0].get<double>(), tail[1].get<double>(), tail[2].get<double>());
    EXPECT_LE(distance(ends.back(), ends.front()), 3e-3) << fps;
  }
}

TEST_F(ToolSimulate, says_what_is_wrong) {
  const auto expect = [&](int status, std::vector<std::string> options, const char* text) {
    const CommandOutcome outcome = simulate(std::move(options));
    EXPECT_EQ(outcome.status, status) << text;
    EXPECT_THAT(outcome.err, HasSubstr(text));
  };
  expect(1, {"--root", path("none.json")}, "none.json: is no file");
  write_file(path("path.json"), "[1, 2]");
  expect(1, {"--root", path("path.json")}, "path.json: is no JSON of the form {\"times\"");
  write_file(path("path.json"), R"({"times": [0, 0], "translations": [[0, 0, 0], [1, 0, 0]]})");
  expect(1, {"--root", path("path.json")}, "path.json: /times/1: is not later than the time before");
  write_file(path("path.json"), R"({"times": [0, 1], "translations": [[0, 0, 0], [1, 0]]})");
  expect(1, {"--root", path("path.json")}, "path.json: /translations/1: is no list of three numbers");
  write_file(path("path.json"), R"({"times": [0], "translations": []})");
  expect(1, {"--root", path("path.json")}, "path.json: /translations: has 0 entries for 1 times");
  expect(2, {"--clip", "walk"}, "--clip walk: no such clip");
  for (const char* place : {"1,2", "1,2,x", "1,2,3,4", "1;2;3", "1,2,1e13", "nan,0,0"})
    expect(2, {"--look-at", place}, "is no place of the form X,Y,Z in metres");
  expect(1, {"--look-at", "1,2,3"}, "hair.gltf: its VRM data do not say how it looks at things (lookAt)");
  expect(2, {"--fps", "100000", "--for", "1000"}, "more than 1000000 frames");
  const CommandOutcome bare = run_tool({"simulate", path("model.gltf"), "-o", path("out.json")});
  EXPECT_EQ(bare.status, 1);
  EXPECT_THAT(bare.err, HasSubstr("model.gltf: it has none of VRM, VRMC_springBone and VRMC_node_constraint"));
}

/// The whole way from a file to a file, beside the stored runs of the corpus.
TEST_F(ToolSimulate, corpus_agrees_with_stored_runs) {
  const auto root = corpus();
  if (!root) GTEST_SKIP() << "no corpus";
  int runs = 0;
  for (const auto& stored : corpus_files("motion", {".json"})) {
    const Json expected = Json::parse(text_of_file(stored));
    if (!expected.is_object() || !expected.contains("frames") || expected.value("fps", 0) != 60) continue;
    Json eight = {{"times", {0.0}}, {"translations", {{0.0, 0.0, 0.0}}}};
    for (const Json& frame : expected["frames"]) {
      const Vec at = figure_of_eight(frame["t"].get<double>());
      eight["times"].push_back(frame["t"]);
      eight["translations"].push_back({at.x, at.y, at.z});
    }
    write_file(path("path.json"), eight.dump());
    const auto model = (*root / "vrm" / expected["file"].get<std::string>()).string();
    ASSERT_EQ(run_tool({"simulate", model, "--for", "3", "--root", path("path.json"), "-o", path("out.json")}).status,
              0);
    const Json run = result();
    ASSERT_EQ(run["frames"].size(), expected["frames"].size());
    double worst = 0.0;
    for (std::size_t f = 0; f < run["frames"].size(); ++f)
      for (std::size_t j = 0; j < expected["joints"].size(); ++j)
        for (int c = 0; c < 3; ++c)
          worst = std::max(worst, std::abs(run["frames"][f]["tail"][j][c].get<double>() -
                                           expected["frames"][f]["tail"][j][c].get<double>()));
    EXPECT_LE(worst, 1e-5) << stored;
    ++runs;
  }
  if (runs == 0) GTEST_SKIP() << "no stored runs";
}

}  // namespace
}  // namespace sinew::test
