// SPDX-License-Identifier: MIT
#include "runtime/animation/side_names.h"

#include <gtest/gtest.h>

#include <numeric>

namespace sinew {
namespace {

struct Pair {
  const char *left, *right;
};

TEST(side_names, the_names_of_known_rigs_are_partners) {
  const Pair pairs[] = {{"upperarm.l", "upperarm.r"},
                        {"Ear_Tip_L", "Ear_Tip_R"},
                        {"lowerarm_l", "lowerarm_r"},
                        {"index_04_leaf_l", "index_04_leaf_r"},
                        {"leg_joint_L_1", "leg_joint_R_1"},
                        {"mixamorig:LeftHandThumb1", "mixamorig:RightHandThumb1"},
                        {"J_Bip_L_UpperArm", "J_Bip_R_UpperArm"},
                        {"Bip01 L Thigh", "Bip01 R Thigh"},
                        {"leftThumbProximal", "rightThumbProximal"},
                        {"DEF-forearm.L.001", "DEF-forearm.R.001"},
                        {"lShldr", "rShldr"},
                        {"LArm", "RArm"},
                        {"HandL", "HandR"},
                        {"l_arm", "r_arm"},
                        {"Hand Left", "Hand Right"},
                        {"LEFT_FOOT", "RIGHT_FOOT"},
                        {"lefthand", "righthand"},
                        {"legleft", "legright"},
                        {"kneeleft_2", "kneeright_2"},
                        {"eyeBlinkLeft", "eyeBlinkRight"},
                        {"foot_left_down", "foot_right_down"}};
  std::vector<std::string> names = {"hips", "Spine", "root.001"};
  for (const Pair& pair : pairs) names.insert(names.end(), {pair.left, pair.right});
  const std::vector<std::uint32_t> partner = name_partners(names);
  for (std::uint32_t i = 0; i < 3; ++i) EXPECT_EQ(partner[i], i) << names[i];
  for (std::uint32_t i = 3; i < names.size(); i += 2) {
    EXPECT_EQ(partner[i], i + 1) << names[i];
    EXPECT_EQ(partner[i + 1], i) << names[i + 1];
    EXPECT_EQ(side_of(names[i]), Side::left) << names[i];
    EXPECT_EQ(side_of(names[i + 1]), Side::right) << names[i + 1];
  }
}

TEST(side_names, a_number_at_the_end_may_differ_where_the_rest_is_unique) {
  const std::vector<std::string> names = {"b_RightUpperArm_06", "b_LeftUpperArm_09", "b_LeftHand_1", "b_LeftHand_2",
                                          "b_RightHand_3"};
  EXPECT_EQ(name_partners(names), (std::vector<std::uint32_t>{1, 0, 2, 3, 4})) << "one right hand for two left ones";
}

TEST(side_names, words_that_only_contain_a_letter_say_nothing) {
  for (const char* name : {"cleftlip", "brightness", "", "Root", "spine", "tail_3", "Roll", "3", "clavicle", "_",
                           "Spine1", "toe.001", "bolt0l", "bolt9r"})
    EXPECT_EQ(side_of(name), Side::none) << name;
}

TEST(side_names, names_that_repeat_have_no_partner) {
  const std::vector<std::string> names = {"hand.l", "hand.r", "hand.r"};
  EXPECT_EQ(name_partners(names), (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST(side_names, partners_are_each_others) {
  const std::vector<std::string> names = {"L_hand_L", "R_hand_L", "L_hand_R", "R_hand_R", "hand_L", "hand_R"};
  const std::vector<std::uint32_t> partner = name_partners(names);
  for (std::uint32_t i = 0; i < names.size(); ++i) EXPECT_EQ(partner[partner[i]], i);
}

}  // namespace
}  // namespace sinew
