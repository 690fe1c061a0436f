// SPDX-License-Identifier: MIT
// `sinew retarget` from outside, and clips of real rigs on other bodies.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include <nlohmann/json.hpp>

#include "importer/export_glb.h"
#include "importer/import_gltf.h"
#include "runtime/math/quaternion.h"
#include "runtime/retarget/hold_feet.h"
#include "runtime/retarget/retarget_animation.h"
#include "tests/importer/tool_model.h"
#include "tests/scenes/hand_scenes.h"
#include "tests/scenes/two_sided.h"
#include "tests/support/corpus.h"
#include "tests/support/tiny_assets.h"

namespace sinew::test {
namespace {
using testing::HasSubstr;
using testing::Not;

/// Hips that go up by 0.5 m and turn an arm half round; names are those that `hips` and `arm` say.
void write_body(const std::string& folder, const std::string& file, const std::string& hips, const std::string& arm,
                double height_m, bool moves) {
  const float numbers[] = {0, 1, 0, 1, 0, 0, 1.5f, 0, 0, 0, 0, 1, 0, 0, 1, 0};
  std::ofstream(folder + file + ".bin", std::ios::binary).write(reinterpret_cast<const char*>(numbers), sizeof numbers);
  std::ofstream out(folder + file + ".gltf");
  out << R"({"asset": {"version": "2.0"}, "scenes": [{"nodes": [0, 3]}], "nodes": [{"name": ")" << hips
      << R"(", "translation": [0, )" << height_m << R"(, 0], "children": [1, 2]}, {"name": ")" << arm
      << R"(", "translation": [0.5, 0.5, 0]}, {"name": "Foot.L", "translation": [0, )" << -height_m
      << R"(, 0]}, {"name": "lamp"}])";
  if (moves)
    out << R"(, "buffers": [{"byteLength": 64, "uri": ")" << file << R"(.bin"}],
      "bufferViews": [{"buffer": 0, "byteLength": 64}],
      "accessors": [{"bufferView": 0, "componentType": 5126, "count": 2, "type": "SCALAR", "min": [0], "max": [1]},
        {"bufferView": 0, "byteOffset": 8, "componentType": 5126, "count": 2, "type": "VEC3"},
        {"bufferView": 0, "byteOffset": 32, "componentType": 5126, "count": 2, "type": "VEC4"}],
      "animations": [{"name": "up", "samplers": [{"input": 0, "output": 1}, {"input": 0, "output": 2}],
        "channels": [{"sampler": 0, "target": {"node": 0, "path": "translation"}},
          {"sampler": 1, "target": {"node": 1, "path": "rotation"}}]}])";
  out << "}";
}

TEST(retarget, plays_clips_on_a_character_of_other_names_and_height) {
  const ToolModelFile model;
  write_body(model.beside(""), "clips", "mixamorig:Hips", "mixamorig:LeftArm", 1.0, true);
  write_body(model.beside(""), "tall", "pelvis", "upperarm_l", 3.0, false);
  const CommandOutcome outcome = run_tool(
      {"retarget", model.beside("clips.gltf"), "--onto", model.beside("tall.gltf"), "-o", model.beside("out.glb")});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("\"upperarm_l\" follows \"mixamorig:LeftArm\""));
  EXPECT_THAT(outcome.out, HasSubstr("3 joints by the bones of a human body or the map, heights 3"));
  EXPECT_THAT(outcome.out, HasSubstr("joints of the character that rest: \"lamp\""));
  EXPECT_THAT(outcome.out, HasSubstr("joints of the clips that nothing follows: \"lamp\""));
  EXPECT_THAT(outcome.out, HasSubstr("\"up\": 2 moved joints, largest error"));
  const auto out = import_gltf(model.beside("out.glb"));
  ASSERT_TRUE(out);
  ASSERT_EQ(out->scene.animations.size(), 1u);
  const BoneAnimation& hips = out->scene.animations[0].bones[0];
  EXPECT_EQ(out->scene.skeleton.names[hips.joint], "pelvis");
  EXPECT_EQ(hips.translation.values, (std::vector<glm::vec3>{{0, 3, 0}, {0, 4.5f, 0}})) << "half a metre, three times";
}

TEST(retarget, a_map_of_ones_own_comes_before_names_and_says_what_is_wrong_with_it) {
  const ToolModelFile model;
  write_body(model.beside(""), "clips", "a", "b", 1.0, true);
  write_body(model.beside(""), "other", "c", "d", 1.0, false);
  const std::string map = model.beside("map.json");
  const auto run = [&](const std::string& text) {
    std::ofstream(map) << text;
    return run_tool({"retarget", model.beside("clips.gltf"), "--onto", model.beside("other.gltf"), "-o",
                     model.beside("out.glb"), "--map", map});
  };
  const CommandOutcome good = run(R"({"joints": {"c": "a", "d": "b"}})");
  ASSERT_EQ(good.status, 0) << good.err;
  EXPECT_THAT(good.out, HasSubstr("\"d\" follows \"b\""));
  EXPECT_THAT(good.out, testing::Not(HasSubstr("\"lamp\" follows")));
  EXPECT_THAT(run(R"({"joints": {"x": "a"}})").err, HasSubstr("the character has no joint \"x\""));
  EXPECT_THAT(run(R"({"joints": {"c": "x"}})").err, HasSubstr("the clips have no joint \"x\""));
  EXPECT_THAT(run(R"({"joints": {"c": 1}})").err, HasSubstr("\"c\" in \"joints\" is no text"));
  EXPECT_THAT(run(R"({"joints": ["c"]})").err, HasSubstr("\"joints\" is no list of names"));
  EXPECT_THAT(run(R"({"bones": {"c": "a"}})").err, HasSubstr("\"bones\" is not \"joints\" or \"translations\""));
  EXPECT_THAT(run(R"({"translations": {"c": "half"}})").err, HasSubstr("\"half\" is no rule"));
  EXPECT_THAT(run(R"({"translations": {"x": "keep"}})").err, HasSubstr("the character has no joint \"x\""));
  EXPECT_THAT(run(R"({"joints": {}})").err, HasSubstr("pairs no joints"));
  EXPECT_EQ(run("[").status, 2);
  EXPECT_EQ(
      run_tool({"retarget", model.beside("clips.gltf"), "--onto", model.beside("other.gltf"), "-o", map, "--map", map})
          .status,
      2)
      << "a file that is read is not written";
}

TEST(retarget, a_character_without_a_like_joint_is_refused) {
  const ToolModelFile model;
  write_body(model.beside(""), "clips", "a", "b", 1.0, true);
  std::ofstream(model.beside("stone.gltf")) << R"({"asset": {"version": "2.0"}, "nodes": [{"name": "stone"}]})";
  const CommandOutcome outcome = run_tool(
      {"retarget", model.beside("clips.gltf"), "--onto", model.beside("stone.gltf"), "-o", model.beside("out.glb")});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("no joint is like one of"));
  EXPECT_FALSE(std::filesystem::exists(model.beside("out.glb")));
}

TEST(retarget, what_sinew_does_not_know_of_the_character_stays) {
  const ToolModelFile model;
  write_body(model.beside(""), "clips", "Hips", "LeftArm", 1.0, true);
  write_body(model.beside(""), "other", "Hips", "LeftArm", 2.0, false);
  std::ifstream in(model.beside("other.gltf"));
  std::string text((std::istreambuf_iterator<char>(in)), {});
  text.insert(1, R"("extras": {"mine": 7}, "extensionsUsed": ["ACME_thing"], "extensions": {"ACME_thing": {"a": 1}},)");
  std::ofstream(model.beside("other.gltf")) << text;
  const auto outcome = run_tool(
      {"retarget", model.beside("clips.gltf"), "--onto", model.beside("other.gltf"), "-o", model.beside("out.gltf")});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_TRUE(std::filesystem::exists(model.beside("out.bin")));
  std::ifstream written(model.beside("out.gltf"));
  const std::string out((std::istreambuf_iterator<char>(written)), {});
  EXPECT_THAT(out, HasSubstr(R"("extras":{"mine":7})"));
  EXPECT_THAT(out, HasSubstr(R"("ACME_thing":{"a":1})"));
  EXPECT_EQ(run_tool({"retarget", model.beside("clips.gltf"), "--onto", model.beside("other.gltf"), "-o",
                      model.beside("out.txt")})
                .status,
            2);
}

TEST(retarget, holds_feet_where_both_have_legs) {
  const ToolModelFile model;
  write_body(model.beside(""), "clips", "Hips", "LeftArm", 1.0, true);
  write_body(model.beside(""), "other", "Hips", "LeftArm", 2.0, false);
  const auto outcome = run_tool({"retarget", model.beside("clips.gltf"), "--onto", model.beside("other.gltf"), "-o",
                                 model.beside("out.glb"), "--hold-feet"});
  EXPECT_EQ(outcome.status, 1);
  EXPECT_THAT(outcome.err, HasSubstr("no leg with thigh, shank and foot follows one of"));

  Scene walker;
  for (const char* name : {"Hips", "LeftUpLeg", "LeftLeg", "LeftFoot"}) {
    const auto j = static_cast<std::uint32_t>(walker.skeleton.joint_count());
    walker.skeleton.parents.push_back(j == 0 ? kNone : j - 1);
    walker.skeleton.rest.push_back({glm::vec3(0, j == 0 ? 1.0f : -0.3f, 0)});
    walker.skeleton.names.emplace_back(name);
    walker.skeleton.fixed_matrix_of.push_back(kNone);
    walker.skeleton.node_of_joint.push_back(j);
    walker.skeleton.joint_of_node.push_back(j);
    walker.skeleton.level_begin.push_back(j);
  }
  walker.skeleton.level_begin.push_back(4);
  ASSERT_TRUE(export_glb(walker, model.beside("body.glb")));
  walker.skeleton.rest[2].translation.y = -0.5f;  // a longer thigh
  BoneAnimation thigh;
  thigh.joint = 1;
  thigh.rotation = {Interpolation::linear, {0, 1}, {quat_identity<float>(), quat_xyzw(0.2f, 0.0f, 0.0f, 0.98f)}};
  thigh.rotation.values[1] = normalised(thigh.rotation.values[1]);
  walker.animations.push_back({"kick", 1.0, {thigh}, {}});
  ASSERT_TRUE(export_glb(walker, model.beside("walk.glb")));
  const auto held = run_tool({"retarget", model.beside("walk.glb"), "--onto", model.beside("body.glb"), "-o",
                              model.beside("out.glb"), "--hold-feet"});
  ASSERT_EQ(held.status, 0) << held.err;
  EXPECT_THAT(held.out, testing::ContainsRegex("feet slide [0-9.]+ mm before and [0-9.]+ [um]*m after in 1 contact"));
  const auto out = import_gltf(model.beside("out.glb"));
  ASSERT_TRUE(out);
  EXPECT_EQ(out->scene.animations[0].bones.size(), 4u) << "shank, foot and hips have keys, too";
}

std::vector<Scene> scenes_in(const std::vector<std::filesystem::path>& files) {
  ImportOptions options;
  options.decode_images = options.make_tangents = options.make_normals = false;
  std::vector<Scene> scenes;
  for (const auto& file : files)
    if (auto imported = import_gltf(file, options)) scenes.push_back(std::move(imported->scene));
  return scenes;
}

/// Clips of every file on every body of which most joints are mapped.
TEST(retarget_corpus, clips_on_other_bodies_are_the_retargeted_poses_and_rest_stays_rest) {
  std::size_t clips = 0;
  const std::vector<Scene> scenes = scenes_in(corpus_files("retarget", {".glb"}));
  for (const Scene& from : scenes)
    for (const Scene& to : scenes) {
      const SkeletonMap map = make_skeleton_map(from.skeleton, to.skeleton, {.limbs = LimbDirections::of_rest});
      if (map.joints.size() < 40) continue;
      const Animation still = retarget_animation({}, map, from.skeleton, to.skeleton);
      EXPECT_TRUE(still.bones.empty());
      for (const Animation& animation : from.animations) {
        const Animation found = retarget_animation(animation, map, from.skeleton, to.skeleton);
        const RetargetError error = measure_retarget(found, animation, map, from.skeleton, to.skeleton, 31.0);
        EXPECT_LT(error.angle_rad, 2e-6) << animation.name;
        EXPECT_LT(error.distance, 2e-5) << animation.name;
        ++clips;
      }
    }
  if (corpus()) {
    EXPECT_GT(clips, 60u);
  }
}

TEST(retarget_corpus, images_of_the_character_stay_as_they_are) {
  const ToolModelFile model;
  ImportOptions options;
  options.decode_images = false;
  options.keep_encoded_images = true;
  const auto images_of = [&](const std::string& file) {
    const auto imported = import_gltf(file, options);
    std::vector<std::vector<std::byte>> encoded;
    if (imported)
      for (const Image& image : imported->scene.images) {
        EXPECT_FALSE(image.encoded.empty()) << file;
        encoded.push_back(image.encoded);
      }
    return encoded;
  };
  std::size_t compared = 0;
  for (const auto& file : corpus_files("retarget", {".glb"})) {
    const auto before = images_of(file.string());
    if (before.empty()) continue;
    const std::string out = model.beside("worn.glb");
    ASSERT_EQ(run_tool({"retarget", file.string(), "--onto", file.string(), "-o", out}).status, 0) << file;
    EXPECT_EQ(images_of(out), before) << file;
    ++compared;
  }
  if (corpus()) {
    EXPECT_GT(compared, 0u);
  }
}

/// Feet of every humanoid's clips on every other body.
TEST(retarget_corpus, held_feet_slide_less) {
  double before = 0.0, after = 0.0;
  const std::vector<Scene> bodies = scenes_in(corpus_files("retarget", {".glb"}));
  for (const Scene& from : scenes_in(corpus_files("models", {".glb"}))) {
    if (from.animations.size() < 10) continue;
    for (const Scene& to : bodies) {
      const SkeletonMap map = make_skeleton_map(from.skeleton, to.skeleton);
      const FeetMap feet = make_feet_map(map, from.skeleton, to.skeleton);
      if (feet.legs.empty()) continue;
      for (const Animation& animation : from.animations) {
        Animation retargeted = retarget_animation(animation, map, from.skeleton, to.skeleton);
        before += measure_foot_slide(feet, animation, from.skeleton, retargeted, to.skeleton).mean;
        hold_feet(feet, animation, from.skeleton, to.skeleton, retargeted);
        after += measure_foot_slide(feet, animation, from.skeleton, retargeted, to.skeleton).mean;
      }
    }
  }
  if (corpus()) {
    EXPECT_GT(before, 0.0);
  }
  EXPECT_LE(after, 0.15 * before);
}

/// Humans follow humanoids of other names: all limbs are found.
TEST(retarget_corpus, limbs_of_humanoids_find_each_other) {
  std::size_t humanoids = 0;
  const std::vector<Scene> bodies = scenes_in(corpus_files("retarget", {".glb"}));
  for (const Scene& from : scenes_in(corpus_files("models", {".glb"}))) {
    if (from.animations.size() < 10) continue;
    for (const Scene& to : bodies) {
      const SkeletonMap map = make_skeleton_map(from.skeleton, to.skeleton);
      humanoids += map.joints.size() >= 18 && !map.by_names;
    }
  }
  if (corpus()) {
    EXPECT_GE(humanoids, 2u);
  }
}

TEST(retarget, carries_morph_weights_by_name_and_lists_what_it_cannot) {
  const ToolModelFile model;
  Scene clips = face_scene(), character = face_scene();
  for (Scene* scene : {&clips, &character}) scene->skeleton.names[0] = "head";
  character.meshes[0].target_names = {"puff", "Face.SPREAD"};
  character.animations.clear();
  for (Scene* scene : {&clips, &character}) finish_scene(*scene);
  ASSERT_TRUE(export_glb(clips, model.beside("clips.glb")) && export_glb(character, model.beside("character.glb")));
  const CommandOutcome outcome = run_tool(
      {"retarget", model.beside("clips.glb"), "--onto", model.beside("character.glb"), "-o", model.beside("out.glb")});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("morph targets that the character lacks: \"lift\"\n"));
  const auto out = import_gltf(model.beside("out.glb"));
  ASSERT_TRUE(out);
  ASSERT_EQ(out->scene.animations.size(), 1u);
  ASSERT_EQ(out->scene.animations[0].weights.size(), 1u);
  const WeightTrack &found = out->scene.animations[0].weights[0].weights,
                    &from = clips.animations[0].weights[0].weights;
  EXPECT_EQ(found.times_s, from.times_s);
  EXPECT_EQ(found.values, (std::vector<float>{0.25f, 0.0f, 0.25f, 2.0f})) << "the rest weight, and the spread";
}

TEST(retarget, carries_properties_by_name_and_lists_those_that_the_character_lacks) {
  const ToolModelFile model;
  Scene clips = face_scene(), character = face_scene();
  for (Scene* scene : {&clips, &character}) scene->skeleton.names[0] = "head";
  clips.materials = {{.name = "hat"}, {.name = "skin"}};
  character.materials = {{.name = "skin"}};
  character.animations.clear();
  character.hidden_joints = {0};
  const WeightTrack rest{Interpolation::step, {0.0f, 0.5f}, {0.0f, 1.0f}, 1},
      colors{Interpolation::cubic_spline, {0.0f, 1.0f}, std::vector<float>(24, 0.125f), 4};
  const auto hat = PropertyTrack{{PropertyKind::base_color, 0}, colors},
             strength = PropertyTrack{{PropertyKind::emissive_strength, 1}, rest};
  clips.materials[1].emissive_strength = 2.0f;
  clips.animations[0].properties = {
      {{PropertyKind::node_visible, 0}, rest}, hat, {{PropertyKind::base_color, 1}, colors}, strength};
  for (Scene* scene : {&clips, &character}) finish_scene(*scene);
  ASSERT_TRUE(export_glb(clips, model.beside("clips.glb")) && export_glb(character, model.beside("character.glb")));
  const CommandOutcome outcome = run_tool(
      {"retarget", model.beside("clips.glb"), "--onto", model.beside("character.glb"), "-o", model.beside("out.glb")});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("  the character has no \"material hat/base_color\"\n"
                                     "  the character has no \"material skin/emissive_strength\"\n"));
  EXPECT_EQ(run_tool({"check", model.beside("out.glb"), "--strict"}).status, 0);
  const auto out = import_gltf(model.beside("out.glb"));
  ASSERT_TRUE(out);
  const auto& found = out->scene.animations.at(0).properties;
  ASSERT_EQ(found.size(), 2u);
  EXPECT_TRUE((found[0].target == PropertyTarget{PropertyKind::node_visible, 0}));
  EXPECT_TRUE((found[1].target == PropertyTarget{PropertyKind::base_color, 0}));
  for (const std::size_t i : {0u, 1u}) {
    const WeightTrack& from = clips.animations[0].properties[2 * i].values;
    EXPECT_EQ(found[i].values.interpolation, from.interpolation);
    EXPECT_EQ(found[i].values.times_s, from.times_s);
    EXPECT_EQ(found[i].values.values, from.values);
  }
}

TEST(retarget, twist_joints_of_the_character_share_what_a_foot_is_twisted) {
  const ToolModelFile model;
  const auto leg = [&](const char* file, bool has_twist) {
    Scene scene;
    scene.skeleton = skeleton_of(has_twist ? std::vector<std::uint32_t>{kNone, 0, 1, 2, 2}
                                           : std::vector<std::uint32_t>{kNone, 0, 1, 2});
    scene.skeleton.names = {"pelvis", "thigh_l", "calf_l", "foot_l"};
    if (has_twist) scene.skeleton.names.emplace_back("calf_twist_01_l");
    const float heights[] = {1.0f, -0.1f, -0.4f, -0.4f, -0.1f};
    for (std::size_t j = 0; j < scene.skeleton.joint_count(); ++j) scene.skeleton.rest[j].translation.y = heights[j];
    BoneAnimation foot;
    foot.joint = 3;
    foot.rotation = {Interpolation::linear, {0, 1}, {{1, 0, 0, 0}, {std::cos(0.4f), 0, std::sin(0.4f), 0}}};
    if (!has_twist) scene.animations = {{"turn", 1.0, {foot}, {}}};
    finish_scene(scene);
    ASSERT_TRUE(export_glb(scene, model.beside(file)));
  };
  leg("clips.glb", false);
  leg("character.glb", true);
  const CommandOutcome outcome = run_tool(
      {"retarget", model.beside("clips.glb"), "--onto", model.beside("character.glb"), "-o", model.beside("out.glb")});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("  \"calf_twist_01_l\" shares the twist of \"foot_l\"\n"));
  EXPECT_THAT(outcome.out, Not(HasSubstr("that rest")));
  const auto out = import_gltf(model.beside("out.glb"));
  ASSERT_TRUE(out);
  const BoneAnimation& twist = out->scene.animations.at(0).bones.at(1);
  EXPECT_EQ(out->scene.skeleton.names[twist.joint], "calf_twist_01_l");
  EXPECT_NEAR(twist.rotation.values.back().y, std::sin(0.1), 1e-6) << "a quarter of the foot's";
}

/// Adds what VRM says about the bones of nodes 0 and 1, and names them otherwise.
void say_bones(const std::string& file, const char* extension, const char* first_name, const char* second_name) {
  nlohmann::json root = nlohmann::json::parse(std::ifstream(file));
  root["nodes"][0]["name"] = first_name;
  root["nodes"][1]["name"] = second_name;
  root["extensionsUsed"] = {extension};
  root["extensions"][extension] = {
      {"specVersion", "1.0"},
      {"humanoid", {{"humanBones", {{"hips", {{"node", 0}}}, {"leftUpperArm", {{"node", 1}}}}}}}};
  std::ofstream(file) << root;
}

TEST(retarget, bones_are_those_that_vrm_says_whatever_their_names) {
  const ToolModelFile model;
  write_body(model.beside(""), "clips", "", "", 1.0, true);
  write_body(model.beside(""), "tall", "", "", 3.0, false);
  say_bones(model.beside("clips.gltf"), "VRMC_vrm_animation", "head", "RightFoot");
  say_bones(model.beside("tall.gltf"), "VRMC_vrm", "\u8170", "\u5de6\u8155");
  const CommandOutcome outcome = run_tool(
      {"retarget", model.beside("clips.gltf"), "--onto", model.beside("tall.gltf"), "-o", model.beside("out.glb")});
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("  \"\u8170\" follows \"head\"\n"));
  EXPECT_THAT(outcome.out, HasSubstr("  \"\u5de6\u8155\" follows \"RightFoot\"\n"));
  EXPECT_THAT(outcome.out, HasSubstr("2 joints by the bones of a human body or the map"));
}

TEST(retarget, translations_follow_the_rule_that_is_asked_for) {
  const ToolModelFile model;
  write_body(model.beside(""), "clips", "mixamorig:Hips", "mixamorig:LeftArm", 1.0, true);
  write_body(model.beside(""), "tall", "pelvis", "upperarm_l", 3.0, false);
  const auto hips = [&](const std::string& rule) {
    const CommandOutcome outcome =
        run_tool({"retarget", model.beside("clips.gltf"), "--onto", model.beside("tall.gltf"), "-o",
                  model.beside(rule + ".glb"), "--translations", rule});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return import_gltf(model.beside(rule + ".glb"))->scene.animations[0].bones[0];
  };
  EXPECT_EQ(hips("hips-by-height").translation.values.size(), 2u);
  EXPECT_TRUE(hips("keep").translation.empty());
  EXPECT_EQ(hips("by-length").translation.values.size(), 2u);
  std::ofstream(model.beside("map.json")) << R"({"translations": {"pelvis": "keep"}})";
  const CommandOutcome outcome = run_tool({"retarget", model.beside("clips.gltf"), "--onto", model.beside("tall.gltf"),
                                           "-o", model.beside("kept.glb"), "--map", model.beside("map.json")});
  EXPECT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("\"upperarm_l\" follows")) << "joints are still mapped by their bones";
  EXPECT_TRUE(import_gltf(model.beside("kept.glb"))->scene.animations[0].bones[0].translation.empty());
  EXPECT_EQ(run_tool({"retarget", "a.glb", "--onto", "b.glb", "-o", "c.glb", "--translations", "half"}).status, 2);
}

/// Arms of another posture point where those of the clips do, or turn by as much from where they rest.
TEST(retarget, limbs_follow_directions_or_keep_their_rest_as_asked) {
  Scene from, to;
  from.skeleton = scenes::two_sided(scenes::RightSide::mirrored_axes, 1).skeleton;
  to.skeleton = scenes::two_sided(scenes::RightSide::another_posture, 2).skeleton;
  to.skeleton.names = {"pelvis", "spine_01", "thigh_l",    "thigh_r",    "head",   "upperarm_l", "upperarm_r",
                       "foot_l", "foot_r",   "lowerarm_l", "lowerarm_r", "hand_l", "hand_r",     "prop"};
  BoneAnimation arm;
  arm.joint = 6;
  arm.rotation = {Interpolation::linear, {0, 1}, {from.skeleton.rest[6].rotation, quat_identity<float>()}};
  from.animations = {{"wave", 1.0, {arm}, {}}};
  const ToolModelFile model;
  ASSERT_TRUE(export_glb(from, model.beside("clips.glb")));
  ASSERT_TRUE(export_glb(to, model.beside("body.glb")));
  const auto rotations = [&](std::vector<std::string> more) {
    std::vector<std::string> line{"retarget", model.beside("clips.glb"), "--onto", model.beside("body.glb"),
                                  "-o",       model.beside("out.glb")};
    line.insert(line.end(), more.begin(), more.end());
    const CommandOutcome outcome = run_tool(line);
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    return import_gltf(model.beside("out.glb"))->scene.animations.at(0).bones.at(0).rotation.values;
  };
  const auto expected = [&](LimbDirections limbs) {
    const SkeletonMap map = make_skeleton_map(from.skeleton, to.skeleton, {.limbs = limbs});
    return retarget_animation(from.animations[0], map, from.skeleton, to.skeleton).bones.at(0).rotation.values;
  };
  ASSERT_NE(expected(LimbDirections::of_source), expected(LimbDirections::of_rest));
  EXPECT_EQ(rotations({}), expected(LimbDirections::of_source));
  EXPECT_EQ(rotations({"--keep-rest"}), expected(LimbDirections::of_rest));
}

}  // namespace
}  // namespace sinew::test
