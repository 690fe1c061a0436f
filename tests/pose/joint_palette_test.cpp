// SPDX-License-Identifier: MIT
#include "runtime/pose/joint_palette.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "runtime/base/same_bits.h"
#include "runtime/math/decompose.h"
#include "tests/support/fixed_random.h"
#include "tests/support/near.h"
#include "tests/support/simd_targets.h"

namespace sinew {
namespace {

TEST(joint_palette, rejects_wrong_sizes_and_joints_out_of_range) {
  Skin skin;
  skin.joints = {0, 2};
  skin.inverse_bind.resize(2);
  std::vector<Affine> model(3);
  std::vector<JointMatrix> palette(2);
  EXPECT_EQ(check(JointPaletteJob{&skin, model, palette}), ErrorCode::ok);
  EXPECT_EQ(check(JointPaletteJob{nullptr, model, palette}), ErrorCode::size_mismatch);
  EXPECT_EQ(check(JointPaletteJob{&skin, model, std::span(palette).first(1)}), ErrorCode::size_mismatch);
  EXPECT_EQ(check(JointPaletteJob{&skin, std::span(model).first(2), palette}), ErrorCode::index_out_of_range);
  skin.inverse_bind.resize(1);
  EXPECT_EQ(check(JointPaletteJob{&skin, model, palette}), ErrorCode::size_mismatch);
}

TEST(joint_palette, the_bind_pose_gives_identities) {
  test::FixedRandom random(3);
  Skin skin;
  std::vector<Affine> model;
  std::vector<JointMatrix> palette(8);
  for (std::uint32_t j = 0; j < 8; ++j) {
    Transform t = random.transform();
    t.scale = glm::vec3(1);
    model.push_back(affine_from_transform(t));
    Transform inverse;
    inverse.rotation = quat_conjugate(t.rotation);
    inverse.translation = -rotate_vector(inverse.rotation, t.translation);
    skin.joints.push_back(j);
    skin.inverse_bind.push_back(affine_from_transform(inverse));
  }
  run(JointPaletteJob{&skin, model, palette});
  for (const auto& m : palette) EXPECT_TRUE(test::is_near(affine_from(m), Affine{}, 1e-6));
}

TEST(joint_palette, N27_N28_every_instruction_set_gives_the_bits_of_the_plain_product) {
  test::FixedRandom random(5);
  Skin skin;
  std::vector<Affine> model;
  for (std::uint32_t j = 0; j < 21; ++j) {
    model.push_back(affine_from_transform(random.transform()));
    skin.joints.push_back((j * 8) % 21);
    skin.inverse_bind.push_back(affine_from_transform(random.transform()));
  }
  model[3].row[1].z = std::numeric_limits<float>::infinity();  // stays out of the last row
  skin.inverse_bind[4] = {{{-1, 0, 0, 0}, {0, -1, 0, 0}, {0, 0, -1, 0}}};
  for (const std::int64_t target : test::simd_targets()) {
    const test::OnlyTarget only(target);
    std::vector<JointMatrix> palette(skin.joints.size());
    run(JointPaletteJob{&skin, model, palette});
    for (std::size_t i = 0; i < palette.size(); ++i) {
      const JointMatrix plain = joint_matrix_from(model[skin.joints[i]] * skin.inverse_bind[i]);
      EXPECT_TRUE(same_bits(palette[i], plain) || skin.joints[i] == 3) << i << ' ' << test::simd_name(target);
      for (int c = 0; c < 4; ++c)
        EXPECT_EQ(palette[i].column[c].w, c == 3 ? 1.0f : 0.0f) << i << ' ' << test::simd_name(target);
    }
  }
}

TEST(joint_palette, G33_joints_may_come_in_any_order) {
  Skin skin;
  skin.joints = {2, 0};
  skin.inverse_bind.resize(2);
  std::vector<Affine> model(3);
  std::vector<JointMatrix> palette(2);
  for (int j = 0; j < 3; ++j) model[static_cast<std::size_t>(j)].row[0].w = static_cast<float>(j);
  run(JointPaletteJob{&skin, model, palette});
  EXPECT_EQ(palette[0].column[3].x, 2.0f);
  EXPECT_EQ(palette[1].column[3].x, 0.0f);
}

Affine rebuilt(const RigidStretch& split) {
  const Mat3<float> linear = matrix_from_unit_quat(split.rigid.real) * matrix_from_stretch(split.stretch);
  return affine_from(linear, translation_of(split.rigid));
}

TEST(split_palette, N19_rotation_times_stretch_is_the_matrix) {
  test::FixedRandom random(5);
  std::vector<JointMatrix> palette;
  for (int i = 0; i < 50; ++i)
    palette.push_back(joint_matrix_from(affine_from_transform(random.transform(0.2, 3)) *
                                        affine_from_transform(random.transform(0.2, 3))));
  palette.push_back(joint_matrix_from(affine_from(Mat3<float>(0.0f), {1, 2, 3})));  // collapsed to a point
  palette.push_back(joint_matrix_from(affine_from(Mat3<float>(-1, 0, 0, 0, 1, 0, 0, 0, 1), {0, 0, 0})));  // mirrored
  std::vector<RigidStretch> split(palette.size());
  bool any = false;
  run(SplitPaletteJob{palette, split, &any});
  EXPECT_TRUE(any);
  for (std::size_t i = 0; i < palette.size(); ++i) {
    EXPECT_TRUE(test::is_near(rebuilt(split[i]), affine_from(palette[i]), 1e-5)) << i;
    EXPECT_NEAR(safe_length(split[i].rigid.real), 1.0f, 1e-6f) << i;
  }
}

TEST(split_palette, N17_signs_follow_the_joints_that_they_are_told_to) {
  test::FixedRandom random(8);
  std::vector<JointMatrix> palette;
  for (int i = 0; i < 40; ++i)
    palette.push_back(
        joint_matrix_from(affine_from_transform(Transform{random.vec3(), random.rotation(), glm::vec3(1)})));
  std::vector<RigidStretch> split(40), plain(40);
  std::vector<JointPair> follow;
  for (std::uint16_t i = 1; i < 40; ++i) follow.push_back({static_cast<std::uint16_t>(i / 2), i});
  run(SplitPaletteJob{palette, plain, nullptr, {}});
  run(SplitPaletteJob{palette, split, nullptr, follow});
  int turned = 0;
  for (const JointPair& pair : follow) {
    EXPECT_GE(quat_dot(split[pair.first].rigid.real, split[pair.second].rigid.real), 0.0f);
    const bool same = split[pair.second].rigid.real == plain[pair.second].rigid.real;
    turned += !same;
    EXPECT_EQ(split[pair.second].rigid.dual, same ? plain[pair.second].rigid.dual : -plain[pair.second].rigid.dual);
  }
  EXPECT_GT(turned, 0);
  const JointPair outside[] = {{0, 40}};
  EXPECT_EQ(check(SplitPaletteJob{palette, split, nullptr, outside}), ErrorCode::index_out_of_range);
}

TEST(split_palette, P12_rigid_palettes_need_no_stretch_phase) {
  test::FixedRandom random(6);
  std::vector<JointMatrix> palette;
  for (int i = 0; i < 50; ++i) {
    Transform t = random.transform();
    t.scale = glm::vec3(1);
    palette.push_back(joint_matrix_from(affine_from_transform(t)));
  }
  std::vector<RigidStretch> split(palette.size());
  bool any = true;
  run(SplitPaletteJob{palette, split, &any});
  EXPECT_FALSE(any);
  palette[7].column[2].z *= 1.01f;
  run(SplitPaletteJob{palette, split, &any});
  EXPECT_TRUE(any);
  EXPECT_EQ(check(SplitPaletteJob{palette, std::span(split).first(3), &any}), ErrorCode::size_mismatch);
}

}  // namespace
}  // namespace sinew
