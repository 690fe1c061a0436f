// SPDX-License-Identifier: MIT
#include "importer/vrm_springs.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/procedures/springs/springs.h"
#include "tests/importer/tiny_gltf.h"
#include "tests/support/near.h"

namespace sinew::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Five nodes in a chain, one metre apart, and node 5 beside it.
TinyGltf chain() {
  TinyGltf file;
  file.root["nodes"] = Json::parse(R"([{"name": "root", "children": [1, 5]},
    {"name": "a", "children": [2], "translation": [0, -1, 0]}, {"name": "b", "children": [3], "translation": [0, -1, 0]},
    {"name": "c", "children": [4], "translation": [0, -1, 0]}, {"name": "d", "translation": [0, -1, 0]},
    {"name": "ball", "translation": [0, 0, 1]}])");
  file.root["scenes"] = Json::parse(R"([{"nodes": [0]}])");
  return file;
}

VrmSprings springs_of(const TinyGltf& file) {
  const auto imported = file.import();
  EXPECT_EQ(outcome(imported), "ok");
  if (!imported || !imported->vrm) return {};
  VrmSprings out = spring_setup_of(*imported->vrm, imported->scene.skeleton);
  const auto made = compile_springs(imported->scene.skeleton, out.setup);
  EXPECT_TRUE(made) << made.error().text;
  return out;
}

TinyGltf with_springs(const char* extension) {
  TinyGltf file = chain();
  file.root["extensionsUsed"] = {"VRMC_springBone", "VRMC_springBone_extended_collider"};
  file.root["extensions"]["VRMC_springBone"] = Json::parse(extension);
  return file;
}

TEST(vrm_springs, version_1_swings_all_joints_but_the_last) {
  const VrmSprings springs = springs_of(with_springs(R"({"specVersion": "1.0",
    "colliders": [{"node": 5, "shape": {"capsule": {"offset": [0, 1, 0], "tail": [0, 2, 0], "radius": 0.5}}},
                  {"node": 0, "shape": {"sphere": {"radius": 9}}, "extensions": {"VRMC_springBone_extended_collider":
                     {"shape": {"sphere": {"radius": 2, "inside": true}}}}}],
    "colliderGroups": [{"colliders": [1, 0]}],
    "springs": [{"center": 0, "colliderGroups": [0], "joints": [
      {"node": 1, "stiffness": 2, "dragForce": 0.25, "gravityPower": 3, "gravityDir": [0, 0, 1], "hitRadius": 0.125},
      {"node": 3}, {"node": 4}]}]})"));
  EXPECT_THAT(springs.left_out, IsEmpty());
  ASSERT_EQ(springs.setup.joints.size(), 2u);
  const SpringJoint& joint = springs.setup.joints[0];
  EXPECT_EQ(joint.tail_m, Vec3<double>(0, -2, 0)) << "over the node between";
  EXPECT_EQ(joint.stiffness, 2.0);
  EXPECT_EQ(joint.drag, 0.25);
  EXPECT_EQ(joint.gravity_m_s, Vec3<double>(0, 0, 3));
  EXPECT_EQ(joint.hit_radius_m, 0.125);
  ASSERT_EQ(springs.setup.groups.size(), 1u);
  EXPECT_NE(springs.setup.groups[0].center, kNone);
  EXPECT_THAT(springs.setup.groups[0].colliders, ElementsAre(1u, 0u));
  EXPECT_TRUE(springs.setup.colliders[1].inside);
  EXPECT_EQ(springs.setup.colliders[1].radius_m, 2.0);
  EXPECT_EQ(springs.setup.colliders[0].kind, SpringCollider::Kind::capsule);
}

TEST(vrm_springs, version_0_swings_everything_below_a_root) {
  TinyGltf file = chain();
  file.root["extensionsUsed"] = {"VRM"};
  file.root["extensions"]["VRM"] = Json::parse(R"({"secondaryAnimation": {"boneGroups": [
    {"stiffiness": 2, "gravityPower": 1, "gravityDir": {"x": 0, "y": -1, "z": 0}, "dragForce": 0.4, "hitRadius": 0.02,
     "bones": [2]}]}})");
  const VrmSprings springs = springs_of(file);
  ASSERT_EQ(springs.setup.joints.size(), 3u);
  EXPECT_EQ(springs.setup.joints[0].tail_m, Vec3<double>(0, -1, 0));
  EXPECT_TRUE(is_near(springs.setup.joints[2].tail_m, Vec3<double>(0, -0.07, 0), 1e-15));
  EXPECT_EQ(springs.setup.joints[2].gravity_m_s, Vec3<double>(0, -1, 0));
}

TEST(vrm_springs, joints_that_cannot_swing_are_left_out_by_name) {
  TinyGltf file = with_springs(R"({"specVersion": "1.0", "colliders": [{"shape": {"sphere": {"radius": 1}}}],
    "colliderGroups": [{"colliders": [0]}],
    "springs": [{"joints": [{"node": 1}, {"node": 2}]},
                {"joints": [{"node": 1}, {"node": 2}, {"node": 3}, {"node": 5}], "colliderGroups": [0]}]})");
  file.root["nodes"][2].erase("translation");
  file.root["nodes"][2]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, -1, 0, 1};
  const VrmSprings springs = springs_of(file);
  EXPECT_THAT(springs.left_out,
              ElementsAre("colliders[0]: it names no node", "springs[1]: joint \"c\" is not above the next one",
                          "springs[1]: joint \"a\" has a spring already",
                          "springs[1]: joint \"b\" has a matrix in place of a rotation"));
  EXPECT_EQ(springs.setup.joints.size(), 1u);
}

}  // namespace
}  // namespace sinew::test
