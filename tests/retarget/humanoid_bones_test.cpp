// SPDX-License-Identifier: MIT
#include "runtime/retarget/humanoid_bones.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <string>

#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

using testing::ElementsAre;

/// Hips, three spine joints, neck and head, a left leg, a left arm with a thumb; names are in this order.
using Names = std::vector<std::string>;
constexpr const char* kBones[] = {"hips",
                                  "spine",
                                  "leftUpperLeg",
                                  "chest",
                                  "leftLowerLeg",
                                  "upperChest",
                                  "leftFoot",
                                  "neck",
                                  "leftShoulder",
                                  "leftToes",
                                  "head",
                                  "leftUpperArm",
                                  "leftLowerArm",
                                  "leftHand",
                                  "leftThumbMetacarpal",
                                  "leftThumbProximal"};

Skeleton body(const Names& names) {
  Skeleton skeleton = test::skeleton_of({kNone, 0, 0, 1, 2, 3, 4, 5, 5, 6, 7, 8, 11, 12, 13, 14});
  skeleton.names = names;
  return skeleton;
}

TEST(humanoid_bones, are_found_by_the_names_of_known_rigs) {
  const std::vector<Names> rigs = {
      {"hips", "spine", "leftUpperLeg", "chest", "leftLowerLeg", "upperChest", "leftFoot", "neck", "leftShoulder",
       "leftToes", "head", "leftUpperArm", "leftLowerArm", "leftHand", "leftThumbMetacarpal", "leftThumbProximal"},
      {"J_Bip_C_Hips", "J_Bip_C_Spine", "J_Bip_L_UpperLeg", "J_Bip_C_Chest", "J_Bip_L_LowerLeg", "J_Bip_C_UpperChest",
       "J_Bip_L_Foot", "J_Bip_C_Neck", "J_Bip_L_Shoulder", "J_Bip_L_ToeBase", "J_Bip_C_Head", "J_Bip_L_UpperArm",
       "J_Bip_L_LowerArm", "J_Bip_L_Hand", "J_Bip_L_Thumb1", "J_Bip_L_Thumb2"},
      {"mixamorig:Hips", "mixamorig:Spine", "mixamorig:LeftUpLeg", "mixamorig:Spine1", "mixamorig:LeftLeg",
       "mixamorig:Spine2", "mixamorig:LeftFoot", "mixamorig:Neck", "mixamorig:LeftShoulder", "mixamorig:LeftToeBase",
       "mixamorig:Head", "mixamorig:LeftArm", "mixamorig:LeftForeArm", "mixamorig:LeftHand", "mixamorig:LeftHandThumb1",
       "mixamorig:LeftHandThumb2"},
      {"pelvis", "spine_01", "thigh_l", "spine_02", "calf_l", "spine_03", "foot_l", "neck_01", "clavicle_l", "ball_l",
       "head", "upperarm_l", "lowerarm_l", "hand_l", "thumb_01_l", "thumb_02_l"},
      {"DEF-hips", "DEF-spine.001", "DEF-thigh.L", "DEF-spine.002", "DEF-shin.L", "DEF-spine.003", "DEF-foot.L",
       "DEF-neck", "DEF-shoulder.L", "DEF-toe.L", "DEF-head", "DEF-upper_arm.L", "DEF-forearm.L", "DEF-hand.L",
       "DEF-thumb.01.L", "DEF-thumb.02.L"},
      {"Hips", "LowerBack", "LeftUpLeg", "Spine", "LeftLeg", "Spine1", "LeftFoot", "Neck", "LeftShoulder",
       "LeftToeBase", "Head", "LeftArm", "LeftForeArm", "LeftHand", "LThumb", "LThumb_end"},
      {"hip", "abdomenLower", "lThighBend", "abdomenUpper", "lShin", "chestLower", "lFoot", "neckLower", "lCollar",
       "lToe", "head", "lShldrBend", "lForearmBend", "lHand", "lThumb1", "lThumb2"}};
  for (const Names& names : rigs) {
    const std::vector<std::uint32_t> joints = find_humanoid_bones(body(names));
    for (std::uint32_t j = 0; j < std::size(kBones); ++j)
      EXPECT_EQ(joints[humanoid_bone(kBones[j])], j) << names[j] << " as " << kBones[j];
    EXPECT_EQ(joints[humanoid_bone("rightHand")], kNone);
  }
}

/// The bones found in a chain of hips, `count` joints and a neck (or a head, if there is no neck).
std::vector<std::uint32_t> bones_of_spine(std::uint32_t count, const char* last = "neck") {
  Skeleton skeleton = test::chain_skeleton(count + 2);
  skeleton.names.assign(count + 2, "joint");
  skeleton.names.front() = "hips";
  skeleton.names.back() = last;
  const std::vector<std::uint32_t> joints = find_humanoid_bones(skeleton);
  return {joints[humanoid_bone("spine")], joints[humanoid_bone("chest")], joints[humanoid_bone("upperChest")]};
}

TEST(humanoid_bones, spines_of_any_length_begin_at_the_hips_and_end_at_the_neck) {
  EXPECT_THAT(bones_of_spine(0), ElementsAre(kNone, kNone, kNone));
  EXPECT_THAT(bones_of_spine(1), ElementsAre(1, kNone, kNone));
  EXPECT_THAT(bones_of_spine(2), ElementsAre(1, 2, kNone));
  EXPECT_THAT(bones_of_spine(3), ElementsAre(1, 2, 3));
  EXPECT_THAT(bones_of_spine(4), ElementsAre(1, 3, 4));
  EXPECT_THAT(bones_of_spine(5), ElementsAre(1, 3, 5));
  EXPECT_THAT(bones_of_spine(3, "head"), ElementsAre(1, 2, 3)) << "of a body without a neck";
  EXPECT_THAT(bones_of_spine(3, "tail"), ElementsAre(kNone, kNone, kNone));
}

TEST(humanoid_bones, the_root_joint_is_the_topmost_of_those_above_the_hips) {
  Skeleton skeleton = test::chain_skeleton(6);
  skeleton.names = {"scene", "root", "DEF-root.001", "holder", "root", "spine"};
  EXPECT_EQ(find_root_joint(skeleton, 3), 1u);
  EXPECT_EQ(find_root_joint(skeleton, 4), 1u);
  EXPECT_EQ(find_root_joint(skeleton, 1), kNone) << "hips are not above themselves";
  EXPECT_EQ(find_root_joint(skeleton, kNone), kNone);
}

TEST(humanoid_bones, controls_and_twist_joints_are_none) {
  Names names(16);
  names[0] = "root";
  names[2] = "handIK.l";
  names[4] = "control-foot-roll.l";
  names[6] = "upperarm_twist_01_l";
  names[8] = "kneeIK.l";
  for (const std::uint32_t joint : find_humanoid_bones(body(names))) EXPECT_EQ(joint, kNone);
}

TEST(humanoid_bones, are_those_that_a_file_names) {
  const auto bones_of = [](std::vector<NamedBone> bones) { return humanoid_bones_of(bones); };
  EXPECT_TRUE(bones_of({}).empty());
  EXPECT_TRUE(bones_of({{"jaw", 7}}).empty()) << "no bone that is retargeted";
  const std::vector<std::uint32_t> bones = bones_of({{"leftHand", 3}, {"jaw", 7}, {"hips", 0}});
  ASSERT_EQ(bones.size(), kHumanoidBones.size());
  EXPECT_EQ(bones[humanoid_bone("leftHand")], 3u);
  EXPECT_EQ(bones[humanoid_bone("hips")], 0u);
  EXPECT_EQ(std::count(bones.begin(), bones.end(), kNone), static_cast<std::ptrdiff_t>(bones.size()) - 2);
}

}  // namespace
}  // namespace sinew
