// SPDX-License-Identifier: MIT
#include "importer/vrm.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "tests/importer/tiny_gltf.h"
#include "tests/support/corpus.h"

namespace sinew::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;

/// Nodes 0 to 3 in a chain, and node 4 with a mesh of one morph target.
TinyGltf character() {
  TinyGltf file;
  Json& primitive = file.add_triangle();
  primitive["targets"] = Json::array({{{"POSITION", file.vec3({1, 0, 0, 0, 0, 0, 0, 0, 0})}}});
  file.root["nodes"] = Json::parse(R"([{"children": [1]}, {"children": [2]}, {"children": [3]}, {}, {"mesh": 0}])");
  return file;
}

/// The joint of a node.
std::uint32_t joint_of(const ImportedFile& file, std::uint32_t node) { return file.scene.skeleton.joint_of_node[node]; }

TEST(vrm, a_file_without_it_has_none) {
  const auto result = character().import();
  ASSERT_EQ(outcome(result), "ok");
  EXPECT_EQ(result->vrm, nullptr);
}

TEST(vrm, names_are_read_up_to_256_characters) {
  TinyGltf file = character();
  file.root["extensionsUsed"] = {"VRMC_vrm"};
  Json& vrm = file.root["extensions"]["VRMC_vrm"];
  vrm = Json::parse(R"({"specVersion": "1.0"})");
  const std::string longest(256, 'a'), longer(257, 'b');
  for (const std::string& name : {longest, longer}) vrm["expressions"]["custom"][name] = Json::object();
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  ASSERT_THAT(result->vrm->expressions, SizeIs(1));
  EXPECT_EQ(result->vrm->expressions[0].name, longest);
  EXPECT_TRUE(warns(result, "extension-value", "/extensions/VRMC_vrm/expressions/custom"));
}

TEST(vrm, version_1_gives_bones_expressions_and_look_at) {
  TinyGltf file = character();
  file.root["extensionsUsed"] = {"VRMC_vrm"};
  file.root["extensions"]["VRMC_vrm"] = Json::parse(R"({"specVersion": "1.0",
    "meta": {"name": "Ann", "authors": ["Bea", "Cid"]},
    "humanoid": {"humanBones": {"hips": {"node": 0}, "head": {"node": 2}}},
    "lookAt": {"type": "bone", "offsetFromHeadBone": [0, 0.06, 0.01]},
    "expressions": {
      "preset": {"happy": {"isBinary": true, "morphTargetBinds": [{"node": 4, "index": 0, "weight": 0.5}]}},
      "custom": {"wink": {"morphTargetBinds": [{"node": 3, "index": 0}]}}}})");
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  ASSERT_NE(result->vrm, nullptr);
  const VrmCharacter& vrm = *result->vrm;
  EXPECT_THAT(result->warnings, IsEmpty());
  EXPECT_EQ(vrm.version, "1.0");
  EXPECT_EQ(vrm.name, "Ann");
  EXPECT_EQ(vrm.authors, "Bea, Cid");
  ASSERT_THAT(vrm.bones, SizeIs(2));
  EXPECT_EQ(vrm.bones[0].name, "head");
  EXPECT_EQ(vrm.bones[0].joint, joint_of(*result, 2));
  EXPECT_EQ(vrm.look_at.kind, VrmLookAt::Kind::bones);
  EXPECT_EQ(vrm.look_at.offset_from_head_m, glm::vec3(0, 0.06f, 0.01f));
  ASSERT_THAT(vrm.expressions, SizeIs(2));
  EXPECT_TRUE(vrm.expressions[0].is_preset && vrm.expressions[0].is_binary);
  ASSERT_THAT(vrm.expressions[0].morphs, SizeIs(1));
  EXPECT_EQ(vrm.expressions[0].morphs[0].instance, 0u);
  EXPECT_EQ(vrm.expressions[0].morphs[0].weight, 0.5f);
  EXPECT_EQ(vrm.expressions[1].name, "wink");
  EXPECT_THAT(vrm.expressions[1].morphs, IsEmpty()) << "node 3 has no mesh";
}

TEST(vrm, version_0_speaks_the_words_of_version_1) {
  TinyGltf file = character();
  file.root["extensionsUsed"] = {"VRM"};
  file.root["extensions"]["VRM"] = Json::parse(R"({"meta": {"title": "Ann", "author": "Bea"},
    "humanoid": {"humanBones": [{"bone": "leftThumbIntermediate", "node": 1}, {"bone": "hips", "node": 0}]},
    "firstPerson": {"lookAtTypeName": "BlendShape", "firstPersonBoneOffset": {"x": 0, "y": 0.06, "z": 0}},
    "blendShapeMaster": {"blendShapeGroups": [
      {"name": "Joy", "presetName": "joy", "binds": [{"mesh": 0, "index": 0, "weight": 25}]},
      {"name": "Mine", "presetName": "unknown", "isBinary": true, "binds": []}]},
    "secondaryAnimation": {
      "colliderGroups": [{"node": 2, "colliders": [{"offset": {"x": 1, "y": 2, "z": 3}, "radius": 0.5}]}],
      "boneGroups": [{"comment": "hair", "stiffiness": 2, "gravityPower": 0.1, "gravityDir": {"x": 0, "y": -1, "z": 0},
                      "dragForce": 0.4, "center": -1, "hitRadius": 0.02, "bones": [1, 2], "colliderGroups": [0]}]}})");
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  ASSERT_NE(result->vrm, nullptr);
  const VrmCharacter& vrm = *result->vrm;
  EXPECT_THAT(result->warnings, IsEmpty());
  EXPECT_EQ(vrm.version, "0.0");
  EXPECT_EQ(vrm.name, "Ann");
  ASSERT_THAT(vrm.bones, SizeIs(2));
  EXPECT_EQ(vrm.bones[0].name, "leftThumbProximal");
  EXPECT_EQ(vrm.look_at.kind, VrmLookAt::Kind::expressions);
  ASSERT_THAT(vrm.expressions, SizeIs(2));
  EXPECT_EQ(vrm.expressions[0].name, "happy");
  EXPECT_EQ(vrm.expressions[0].morphs.at(0).weight, 0.25f);
  EXPECT_EQ(vrm.expressions[0].morphs[0].instance, 0u);
  EXPECT_EQ(vrm.expressions[1].name, "Mine");
  EXPECT_FALSE(vrm.expressions[1].is_preset);
  ASSERT_THAT(vrm.colliders, SizeIs(1));
  EXPECT_EQ(vrm.colliders[0].offset_m, glm::vec3(1, 2, -3)) << "0.x counts z the other way";
  ASSERT_THAT(vrm.springs, SizeIs(2)) << "one for each root";
  EXPECT_EQ(vrm.springs[1].joints.at(0).joint, joint_of(*result, 2));
  EXPECT_EQ(vrm.springs[1].joints[0].stiffness, 2.0f);
  EXPECT_EQ(vrm.springs[1].center, kNone);
  EXPECT_THAT(vrm.springs[1].colliders, ElementsAre(0u));
}

TEST(vrm, version_0_has_the_defaults_of_its_engine) {
  TinyGltf file = character();
  file.root["extensionsUsed"] = {"VRM"};
  file.root["extensions"]["VRM"] = Json::parse(R"({"humanoid": {"humanBones": [{"bone": "hips", "node": 0}]},
    "blendShapeMaster": {"blendShapeGroups": [{"name": "Joy", "presetName": "joy", "binds": [{"mesh": 0, "index": 0}]}]},
    "secondaryAnimation": {"boneGroups": [{"bones": [1], "center": 2}]}})");
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  const VrmCharacter& vrm = *result->vrm;
  EXPECT_EQ(vrm.springs.at(0).center, joint_of(*result, 2));
  EXPECT_EQ(vrm.expressions.at(0).morphs.at(0).weight, 1.0f);
  const VrmSpringJoint joint = vrm.springs.at(0).joints.at(0);
  EXPECT_EQ(joint.stiffness, 1.0f);
  EXPECT_EQ(joint.drag_force, 0.5f);
  EXPECT_EQ(joint.gravity_power, 0.0f);
  EXPECT_EQ(joint.hit_radius_m, 0.0f);
}

TEST(vrm, version_0_springs_have_their_comment_as_name_and_hang_down) {
  TinyGltf file = character();
  file.root["extensionsUsed"] = {"VRM"};
  file.root["extensions"]["VRM"] = Json::parse(R"({"humanoid": {"humanBones": [{"bone": "hips", "node": 0}]},
    "blendShapeMaster": {"blendShapeGroups": [{"name": "one", "presetName": "JOY"}, {"name": "two", "presetName": "Blink_L"}]},
    "secondaryAnimation": {"boneGroups": [{"comment": "hair", "bones": [1]}]}})");
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  EXPECT_EQ(result->vrm->springs.at(0).name, "hair");
  EXPECT_EQ(result->vrm->springs[0].joints.at(0).gravity_direction, glm::vec3(0, -1, 0));
  EXPECT_EQ(result->vrm->expressions.at(0).name, "happy") << "presets are written in capitals, too";
  EXPECT_EQ(result->vrm->expressions.at(1).name, "blinkLeft");
}

TEST(vrm, an_animation_says_that_it_is_one) {
  TinyGltf file = character();
  file.root["extensionsUsed"] = {"VRMC_vrm_animation"};
  file.root["extensions"]["VRMC_vrm_animation"] = Json::parse(R"({"specVersion": "1.0",
    "humanoid": {"humanBones": {"hips": {"node": 1}}},
    "expressions": {"preset": {"happy": {"node": 2}}, "custom": {"wink": {"node": 3}}}})");
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  const VrmCharacter& vrm = *result->vrm;
  EXPECT_TRUE(vrm.is_animation);
  EXPECT_EQ(vrm.version, "1.0");
  EXPECT_EQ(vrm.bones.at(0).joint, joint_of(*result, 1));
  ASSERT_THAT(vrm.expressions, SizeIs(2));
  EXPECT_TRUE(vrm.expressions[0].name == "happy" && vrm.expressions[0].is_preset);
  EXPECT_TRUE(vrm.expressions[1].name == "wink" && !vrm.expressions[1].is_preset);
}

TEST(vrm, each_number_of_a_spring_is_its_own_and_the_version_is_that_of_the_character) {
  TinyGltf file = character();
  file.root["extensionsUsed"] = {"VRMC_vrm", "VRMC_springBone", "VRMC_node_constraint"};
  file.root["extensions"]["VRMC_vrm"] =
      Json::parse(R"({"specVersion": "1.0", "humanoid": {"humanBones": {"hips": {"node": 0}}}})");
  file.root["extensions"]["VRMC_springBone"] = Json::parse(R"({"specVersion": "1.1", "springs": [{"joints":
    [{"node": 1, "hitRadius": 0.125, "stiffness": 0.25, "gravityPower": 0.5, "dragForce": 0.75}]}]})");
  file.root["nodes"][3]["extensions"]["VRMC_node_constraint"] =
      Json::parse(R"({"specVersion": "1.2", "constraint": {"rotation": {"source": 0}}})");
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  EXPECT_EQ(result->vrm->version, "1.0");
  EXPECT_FALSE(result->vrm->is_animation);
  const VrmSpringJoint joint = result->vrm->springs.at(0).joints.at(0);
  EXPECT_EQ(joint.hit_radius_m, 0.125f);
  EXPECT_EQ(joint.stiffness, 0.25f);
  EXPECT_EQ(joint.gravity_power, 0.5f);
  EXPECT_EQ(joint.drag_force, 0.75f);
}

TEST(vrm, a_number_out_of_its_range_is_told_with_the_range) {
  TinyGltf file = character();
  file.root["extensionsUsed"] = {"VRM"};
  file.root["extensions"]["VRM"] = Json::parse(R"({"humanoid": {"humanBones": [{"bone": "hips", "node": 0}]},
    "secondaryAnimation": {"boneGroups": [{"bones": [1], "stiffiness": -2}]}})");
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  ASSERT_THAT(result->warnings, SizeIs(1));
  EXPECT_NE(result->warnings[0].detail.find("number from 0.0"), std::string::npos) << result->warnings[0].detail;
  EXPECT_EQ(result->vrm->springs.at(0).joints.at(0).stiffness, 1.0f);
}

TEST(vrm, constraints_without_a_weight_have_weight_1) {
  for (const char* kind : {"roll", "aim", "rotation"}) {
    TinyGltf file = character();
    file.root["extensionsUsed"] = {"VRMC_node_constraint"};
    Json& constraint = file.root["nodes"][3]["extensions"]["VRMC_node_constraint"]["constraint"];
    constraint[kind] = {{"source", 0}, {"rollAxis", "Z"}, {"aimAxis", "PositiveX"}};
    const auto result = file.import();
    ASSERT_EQ(outcome(result), "ok") << kind;
    ASSERT_THAT(result->vrm->constraints, SizeIs(1)) << kind;
    EXPECT_EQ(result->vrm->constraints[0].weight, 1.0f) << kind;
  }
}

TEST(vrm, springs_and_constraints_are_read_without_a_humanoid) {
  TinyGltf file = character();
  file.root["extensionsUsed"] = {"VRMC_springBone", "VRMC_node_constraint"};
  file.root["extensions"]["VRMC_springBone"] = Json::parse(R"({"specVersion": "1.0",
    "colliders": [{"node": 0, "shape": {"capsule": {"offset": [0, 1, 0], "tail": [0, 2, 0], "radius": 0.1}}},
                  {"node": 0, "shape": {"sphere": {"radius": 9}}, "extensions": {"VRMC_springBone_extended_collider":
                    {"specVersion": "1.0", "shape": {"plane": {"normal": [0, 0, 1]}}}}}],
    "colliderGroups": [{"colliders": [1]}, {"colliders": [0, 1]}],
    "springs": [{"name": "tail", "center": 0, "colliderGroups": [1, 0],
                 "joints": [{"node": 1, "stiffness": 0.5, "gravityDir": [1, 0, 0]}, {"node": 2}]}]})");
  file.root["nodes"][3]["extensions"]["VRMC_node_constraint"] = Json::parse(
      R"({"specVersion": "1.0", "constraint": {"aim": {"source": 0, "aimAxis": "NegativeY", "weight": 0.5}}})");
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  ASSERT_NE(result->vrm, nullptr);
  const VrmCharacter& vrm = *result->vrm;
  EXPECT_THAT(result->warnings, IsEmpty());
  ASSERT_THAT(vrm.colliders, SizeIs(2));
  EXPECT_EQ(vrm.colliders[0].kind, VrmCollider::Kind::capsule);
  EXPECT_EQ(vrm.colliders[0].tail_m, glm::vec3(0, 2, 0));
  EXPECT_EQ(vrm.colliders[1].kind, VrmCollider::Kind::plane) << "the extended shape counts";
  ASSERT_THAT(vrm.springs, SizeIs(1));
  EXPECT_THAT(vrm.springs[0].colliders, ElementsAre(0u, 1u, 1u));
  EXPECT_EQ(vrm.springs[0].center, joint_of(*result, 0));
  ASSERT_THAT(vrm.springs[0].joints, SizeIs(2));
  EXPECT_EQ(vrm.springs[0].joints[0].stiffness, 0.5f);
  EXPECT_EQ(vrm.springs[0].joints[0].gravity_direction, glm::vec3(1, 0, 0));
  EXPECT_EQ(vrm.springs[0].joints[1].stiffness, 1.0f) << "the default";
  ASSERT_THAT(vrm.constraints, SizeIs(1));
  EXPECT_EQ(vrm.constraints[0].kind, VrmConstraint::Kind::aim);
  EXPECT_EQ(vrm.constraints[0].axis, glm::vec3(0, -1, 0));
  EXPECT_EQ(vrm.constraints[0].source, joint_of(*result, 0));
  EXPECT_EQ(vrm.constraints[0].joint, joint_of(*result, 3));
}

TEST(vrm, wrong_values_are_reported_and_the_rest_is_read) {
  TinyGltf file = character();
  file.root["extensionsUsed"] = {"VRMC_vrm", "VRMC_springBone"};
  file.root["extensions"]["VRMC_vrm"] = Json::parse(R"({"specVersion": 1, "meta": [], "humanoid": {"humanBones": {
    "hips": {"node": 77}, "head": {"node": 1}, "spine": 3}}, "expressions": {"preset": {"happy":
    {"morphTargetBinds": [7, {"node": 4, "index": 0, "weight": 3}]}}}})");
  file.root["extensions"]["VRMC_springBone"] = Json::parse(R"({"springs": [{"joints": 5, "colliderGroups": [0]}]})");
  const auto result = file.import();
  ASSERT_EQ(outcome(result), "ok");
  const std::string vrm = "/extensions/VRMC_vrm/";
  EXPECT_TRUE(warns(result, "extension-value", vrm + "specVersion"));
  EXPECT_TRUE(warns(result, "extension-value", vrm + "meta"));
  EXPECT_TRUE(warns(result, "extension-value", vrm + "humanoid/humanBones/hips/node"));
  EXPECT_TRUE(warns(result, "extension-value", vrm + "expressions/preset/happy/morphTargetBinds/0"));
  EXPECT_TRUE(warns(result, "extension-value", vrm + "expressions/preset/happy/morphTargetBinds/1/weight"));
  EXPECT_TRUE(warns(result, "extension-value", "/extensions/VRMC_springBone/springs/0/joints"));
  EXPECT_TRUE(warns(result, "extension-value", "/extensions/VRMC_springBone/springs/0/colliderGroups/0"));
  ASSERT_THAT(result->vrm->bones, SizeIs(1));
  EXPECT_EQ(result->vrm->expressions.at(0).morphs.at(0).weight, 1.0f);
}

TEST(vrm_corpus, files_have_bones_springs_or_constraints) {
  const auto files = files_for_tests("vrm", {".gltf", ".glb", ".vrm", ".vrma"});
  ASSERT_FALSE(files.empty());
  for (const auto& file : files) {
    const auto result = import_gltf(file);
    ASSERT_TRUE(result) << file;
    ASSERT_NE(result->vrm, nullptr) << file;
    const VrmCharacter& vrm = *result->vrm;
    EXPECT_FALSE(vrm.version.empty()) << file;
    EXPECT_GT(vrm.bones.size() + vrm.springs.size() + vrm.constraints.size(), 0u) << file;
    for (const ImportIssue& warning : result->warnings) EXPECT_NE(warning.rule, "extension-value") << file;
  }
}

}  // namespace
}  // namespace sinew::test
