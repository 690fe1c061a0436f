// SPDX-License-Identifier: MIT
#include "importer/vrm_animation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "importer/import_gltf.h"
#include "runtime/animation/track_sample.h"
#include "tests/importer/tiny_gltf.h"
#include "tests/importer/tool_model.h"
#include "tests/support/file_text.h"

namespace sinew::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// Hips, and the joints of three expressions: "happy" rises over 2 s, "blink" is 1 and "wink" moves.
TinyGltf animation(const char* interpolation = "LINEAR",
                   const std::vector<float>& gaze = {0, 0, 0, 1, 0, 0.38268343f, 0, 0.92387953f}) {
  TinyGltf file;
  file.root["nodes"] = Json::parse(
      R"([{"name": "hips", "translation": [0, 1, 0]}, {"name": "happy"}, {"name": "blink"}, {"name": "wink"}, {"name": "gaze"}])");
  file.root["scenes"] = Json::parse(R"([{"nodes": [0, 1, 2, 3, 4]}])");
  const auto times = file.times({0, 2});
  file.animate("translation", times, file.vec3({0, 0, 0, 2, 0, 0}));
  Json& clip = file.root["animations"][0];
  clip["samplers"].push_back({{"input", times}, {"output", file.vec3({1, 0, 0, 1, 0, 0})}});
  clip["samplers"][0]["interpolation"] = interpolation;
  clip["channels"][0]["target"]["node"] = 1;
  // Unless it is given, the gaze goes to 45 degrees to the left.
  clip["samplers"].push_back({{"input", times}, {"output", file.vec4(gaze)}});
  clip["channels"].push_back({{"sampler", 2}, {"target", {{"node", 4}, {"path", "rotation"}}}});
  for (const int node : {2, 3})
    clip["channels"].push_back({{"sampler", 1}, {"target", {{"node", node}, {"path", "translation"}}}});
  file.root["extensionsUsed"] = {"VRMC_vrm_animation"};
  file.root["extensions"]["VRMC_vrm_animation"] = Json::parse(R"({"specVersion": "1.0",
    "humanoid": {"humanBones": {"hips": {"node": 0}}}, "lookAt": {"node": 4},
    "expressions": {"preset": {"happy": {"node": 1}, "blink": {"node": 2}}, "custom": {"wink": {"node": 3}}}})");
  return file;
}

/// Adds a head with eyes that turn by up to 12 degrees outwards and 8 inwards, or whose morph target is the first.
void add_eyes(TinyGltf& file, const char* kind) {
  for (const char* name : {"head", "l", "r"}) file.root["nodes"].push_back({{"name", name}});
  file.root["nodes"][0]["children"] = {1, 2, 3, 4};
  Json& vrm = file.root["extensions"]["VRMC_vrm"];
  vrm["humanoid"]["humanBones"].update(
      Json::parse(R"({"head": {"node": 2}, "leftEye": {"node": 3}, "rightEye": {"node": 4}})"));
  vrm["lookAt"] = Json::parse(R"({"rangeMapHorizontalOuter": {"inputMaxValue": 90, "outputScale": 12},
                                  "rangeMapHorizontalInner": {"inputMaxValue": 90, "outputScale": 8}})");
  vrm["lookAt"]["type"] = kind;
  if (kind == std::string("expression")) {
    vrm["lookAt"]["rangeMapHorizontalOuter"]["outputScale"] = 1;
    vrm["expressions"] = Json::parse(R"({"preset": {"lookLeft": {"morphTargetBinds": [{"node": 1, "index": 0}]}}})");
  }
}

/// A face with two morph targets. "happy" moves the first and weakens "blink", which moves the second.
TinyGltf face() {
  TinyGltf file;
  Json& primitive = file.add_triangle();
  const auto bump = [&] { return Json{{"POSITION", file.vec3({1, 0, 0, 0, 0, 0, 0, 0, 0})}}; };
  primitive["targets"] = Json::array({bump(), bump()});
  file.root["nodes"] = Json::parse(R"([{"name": "hips", "translation": [0, 1, 0], "children": [1]}, {"mesh": 0}])");
  file.root["scenes"] = Json::parse(R"([{"nodes": [0]}])");
  file.root["extensionsUsed"] = {"VRMC_vrm"};
  file.root["extensions"]["VRMC_vrm"] = Json::parse(R"({"specVersion": "1.0",
    "humanoid": {"humanBones": {"hips": {"node": 0}}}, "expressions": {
    "preset": {"blink": {"morphTargetBinds": [{"node": 1, "index": 1, "weight": 0.5}]},
               "happy": {"overrideBlink": "blend", "morphTargetBinds": [{"node": 1, "index": 0}]}}}})");
  return file;
}

std::vector<float> weights_at(const WeightAnimation& track, double time_s) {
  std::vector<float> out(track.weights.target_count);
  sample_track<float>(track.weights, time_s, out);
  return out;
}

TEST(vrm_animation, expressions_become_weights_with_the_overrides_of_the_character) {
  TinyGltf clip_file = animation(), face_file = face();
  const auto clip = clip_file.import(), character = face_file.import();
  ASSERT_EQ(outcome(clip), "ok");
  ASSERT_EQ(outcome(character), "ok");
  const FaceTracks tracks = face_tracks(clip->scene.animations[0], *clip->vrm, *character->vrm, character->scene);
  EXPECT_THAT(tracks.not_found, ElementsAre("wink"));
  ASSERT_EQ(tracks.weights.size(), 1u);
  EXPECT_THAT(weights_at(tracks.weights[0], 0.0), ElementsAre(0.0f, 0.5f));
  EXPECT_THAT(weights_at(tracks.weights[0], 2.0), ElementsAre(1.0f, 0.0f)) << "2 counts as 1, and holds the blink back";
  EXPECT_TRUE(check(tracks.weights[0].weights) == ErrorCode::ok);
}

TEST(vrm_animation, tracks_that_are_not_linear_are_sampled_sixty_times_a_second) {
  TinyGltf clip_file = animation("STEP"), face_file = face();
  const auto clip = clip_file.import(), character = face_file.import();
  ASSERT_EQ(outcome(clip), "ok");
  const FaceTracks tracks = face_tracks(clip->scene.animations[0], *clip->vrm, *character->vrm, character->scene);
  ASSERT_EQ(tracks.weights.size(), 1u);
  EXPECT_EQ(tracks.weights[0].weights.key_count(), 121u);
  EXPECT_THAT(weights_at(tracks.weights[0], 1.97), ElementsAre(0.0f, 0.5f)) << "it steps at 2 s";
}

TEST(vrm_animation, the_gaze_turns_eyes_or_moves_their_expressions) {
  TinyGltf clip_file = animation(), bones_file = face(), weights_file = face();
  add_eyes(bones_file, "bone");
  add_eyes(weights_file, "expression");
  const auto clip = clip_file.import(), bones = bones_file.import(), weights = weights_file.import();
  ASSERT_EQ(outcome(clip), "ok");
  ASSERT_EQ(outcome(bones), "ok");
  ASSERT_EQ(outcome(weights), "ok");
  const FaceTracks turned = face_tracks(clip->scene.animations[0], *clip->vrm, *bones->vrm, bones->scene);
  ASSERT_EQ(turned.eyes.size(), 2u);
  const double half_degree = std::numbers::pi / 360.0;
  EXPECT_NEAR(static_cast<double>(turned.eyes[0].rotation.values.back().y), std::sin(6.0 * half_degree), 1e-6);
  EXPECT_NEAR(static_cast<double>(turned.eyes[1].rotation.values.back().y), std::sin(4.0 * half_degree), 1e-6);
  EXPECT_NEAR(static_cast<double>(turned.eyes[0].rotation.values.front().y), 0.0, 1e-7);
  const FaceTracks moved = face_tracks(clip->scene.animations[0], *clip->vrm, *weights->vrm, weights->scene);
  EXPECT_TRUE(moved.eyes.empty());
  ASSERT_EQ(moved.weights.size(), 1u);
  EXPECT_NEAR(weights_at(moved.weights[0], 2.0)[0], 0.5f, 1e-6f);
}

TEST(vrm_animation, a_gaze_goes_down_by_turns_about_x) {
  TinyGltf clip_file = animation("LINEAR", {0, 0, 0, 1, 0.38268343f, 0, 0, 0.92387953f}), bones_file = face();
  add_eyes(bones_file, "bone");
  const auto clip = clip_file.import(), bones = bones_file.import();
  ASSERT_EQ(outcome(clip), "ok");
  ASSERT_EQ(outcome(bones), "ok");
  const FaceTracks turned = face_tracks(clip->scene.animations[0], *clip->vrm, *bones->vrm, bones->scene);
  ASSERT_EQ(turned.eyes.size(), 2u);
  for (const BoneAnimation& eye : turned.eyes) {  // 45 of 90 degrees are 5 of 10
    EXPECT_NEAR(static_cast<double>(eye.rotation.values.back().x), std::sin(5.0 * std::numbers::pi / 360.0), 1e-6);
    EXPECT_NEAR(static_cast<double>(eye.rotation.values.back().y), 0.0, 1e-7);
  }
}

TEST(vrm_animation, retarget_plays_it_on_a_character_and_says_what_it_leaves_out) {
  const ToolModelFile folder;
  write_file(folder.beside("clip.gltf"), animation().text());
  write_file(folder.beside("face.gltf"), face().text());
  const CommandOutcome outcome = run_tool(
      {"retarget", folder.beside("clip.gltf"), "--onto", folder.beside("face.gltf"), "-o", folder.beside("out.glb")});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("the character does not show the expression \"wink\""));
  const auto played = import_gltf(folder.beside("out.glb"));
  ASSERT_TRUE(played);
  ASSERT_EQ(played->scene.animations.size(), 1u);
  const Animation& clip = played->scene.animations[0];
  EXPECT_EQ(clip.duration_s, 2.0);
  ASSERT_EQ(clip.weights.size(), 1u);
  EXPECT_THAT(weights_at(clip.weights[0], 1.0), ElementsAre(0.5f, 0.25f));
}

}  // namespace
}  // namespace sinew::test
