// SPDX-License-Identifier: MIT
#include "importer/vrm_look_at.h"

#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "tests/importer/tiny_gltf.h"

namespace sinew::test {
namespace {

constexpr float kDegree = std::numbers::pi_v<float> / 180.0f;

TinyGltf three_nodes() {
  TinyGltf file;
  file.root["nodes"] = Json::parse(R"([{"children": [1, 2]}, {}, {}])");
  file.root["scenes"] = Json::parse(R"([{"nodes": [0]}])");
  return file;
}

TEST(vrm_look_at, ranges_of_vrm_1_are_degrees_of_joints_or_weights) {
  TinyGltf file = three_nodes();
  file.root["extensionsUsed"] = {"VRMC_vrm"};
  Json& vrm = file.root["extensions"]["VRMC_vrm"];
  vrm = Json::parse(R"({"specVersion": "1.0",
    "humanoid": {"humanBones": {"head": {"node": 0}, "leftEye": {"node": 1}, "rightEye": {"node": 2}}},
    "expressions": {"preset": {"lookUp": {}, "lookLeft": {}}, "custom": {"lookRight": {}}},
    "lookAt": {"type": "bone", "offsetFromHeadBone": [0, 0.06, 0.1],
               "rangeMapHorizontalInner": {"inputMaxValue": 45, "outputScale": 8},
               "rangeMapVerticalUp": {"inputMaxValue": -3, "outputScale": "far"}}})");
  auto imported = file.import();
  ASSERT_EQ(outcome(imported), "ok");
  auto eyes = eyes_of(*imported->vrm);
  ASSERT_TRUE(eyes);
  EXPECT_EQ(eyes->kind, EyeKind::joints);
  EXPECT_NE(eyes->left, eyes->right);
  EXPECT_EQ(eyes->forward, Vec3<float>(0, 0, 1));
  EXPECT_EQ(eyes->between_eyes_m, Vec3<float>(0, 0.06f, 0.1f));
  EXPECT_FLOAT_EQ(eyes->inner.most_rad, 45 * kDegree);
  EXPECT_FLOAT_EQ(eyes->inner.output, 8 * kDegree);
  EXPECT_FLOAT_EQ(eyes->outer.output, 10 * kDegree) << "as in the reference implementation, where files say nothing";
  EXPECT_FLOAT_EQ(eyes->upward.most_rad, 90 * kDegree) << "a wrong number is reported and left out";
  EXPECT_TRUE(prepare_eyes(imported->scene.skeleton, *eyes));

  vrm["lookAt"]["type"] = "expression";
  imported = file.import();
  ASSERT_EQ(outcome(imported), "ok");
  eyes = eyes_of(*imported->vrm);
  ASSERT_TRUE(eyes);
  EXPECT_EQ(eyes->kind, EyeKind::weights);
  EXPECT_EQ(eyes->outer.output, 1.0f);
  EXPECT_EQ(eyes->left, kNone);
  const LookExpressions look = look_expressions_of(*imported->vrm);
  EXPECT_EQ(look.right, kNone) << "a custom expression is none of the presets";
  EXPECT_EQ(look.down, kNone);
  std::vector<float> values(3, 0.25f);
  set_look_values(look, {.left = 0.5f, .right = 0.75f, .up = 1.0f}, values);
  EXPECT_EQ(values[look.left], 0.5f);
  EXPECT_EQ(values[look.up], 1.0f);
  EXPECT_EQ(values[2], 0.25f) << "expressions of other parts stay";

  vrm["lookAt"].erase("type");
  imported = file.import();
  EXPECT_FALSE(eyes_of(*imported->vrm));
}

TEST(vrm_look_at, vrm_0_faces_minus_z_in_the_axes_of_unity) {
  TinyGltf file = three_nodes();
  file.root["extensionsUsed"] = {"VRM"};
  file.root["extensions"]["VRM"] = Json::parse(R"({"specVersion": "0.0",
    "humanoid": {"humanBones": [{"bone": "head", "node": 0}, {"bone": "leftEye", "node": 1}]},
    "firstPerson": {"lookAtTypeName": "Bone", "firstPersonBoneOffset": {"x": 0, "y": 0.06, "z": 0.1},
                    "lookAtHorizontalOuter": {"xRange": 60, "yRange": 12, "curve": [0, 0, 0, 1, 1, 1, 1, 0]}}})");
  const auto imported = file.import();
  ASSERT_EQ(outcome(imported), "ok");
  const auto eyes = eyes_of(*imported->vrm);
  ASSERT_TRUE(eyes);
  EXPECT_EQ(eyes->forward, Vec3<float>(0, 0, -1));
  EXPECT_EQ(eyes->between_eyes_m, Vec3<float>(0, 0.06f, -0.1f)) << "in front of the face";
  EXPECT_EQ(eyes->right, kNone);
  EXPECT_FLOAT_EQ(eyes->outer.most_rad, 60 * kDegree);
  EXPECT_FLOAT_EQ(eyes->outer.output, 12 * kDegree);
}

}  // namespace
}  // namespace sinew::test
