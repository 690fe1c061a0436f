// SPDX-License-Identifier: MIT
#include "runtime/pose/joint_palette.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

#include "runtime/base/same_bits.h"
#include "runtime/math/decompose.h"
#include "runtime/math/determinant_sign.h"
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
  EXPECT_EQ(check(JointPaletteJob{&skin, model, palette, palette}), ErrorCode::ok);
  EXPECT_EQ(check(JointPaletteJob{&skin, model, palette, std::span(palette).first(1)}), ErrorCode::size_mismatch);
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
  EXPECT_EQ(run(JointPaletteJob{&skin, model, palette}), ErrorCode::ok);
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
    EXPECT_EQ(run(JointPaletteJob{&skin, model, palette}), ErrorCode::ok);
    for (std::size_t i = 0; i < palette.size(); ++i) {
      const JointMatrix plain = joint_matrix_from(model[skin.joints[i]] * skin.inverse_bind[i]);
      EXPECT_TRUE(same_bits(palette[i], plain) || skin.joints[i] == 3) << i << ' ' << test::simd_name(target);
      for (int c = 0; c < 4; ++c)
        EXPECT_EQ(palette[i].column[c].w, c == 3 ? 1.0f : 0.0f) << i << ' ' << test::simd_name(target);
    }
  }
}

TEST(joint_palette, tells_whether_every_bit_is_as_before_in_place_and_beside_another_palette) {
  test::FixedRandom random(7);
  constexpr std::uint32_t kCount = 5;
  Skin skin;
  std::vector<Affine> model;
  for (std::uint32_t j = 0; j < kCount; ++j) {
    model.push_back(affine_from_transform(random.transform()));
    skin.joints.push_back(j);
    skin.inverse_bind.push_back(affine_from_transform(random.transform()));
  }
  for (const std::int64_t target : test::simd_targets()) {
    const test::OnlyTarget only(target);
    std::vector<JointMatrix> made(kCount);
    bool unchanged = true;
    EXPECT_EQ(run(JointPaletteJob{&skin, model, made, {}, &unchanged}), ErrorCode::ok);
    EXPECT_FALSE(unchanged) << "there was nothing before";
    for (std::uint32_t changed = 0; changed <= kCount; ++changed) {
      SCOPED_TRACE(testing::Message() << changed << ' ' << test::simd_name(target));
      std::vector<JointMatrix> before = made, beside(kCount);
      if (changed < kCount) before[changed].column[3].z = std::nextafter(before[changed].column[3].z, 9.0f);
      EXPECT_EQ(run(JointPaletteJob{&skin, model, beside, before, &unchanged}), ErrorCode::ok);
      EXPECT_EQ(unchanged, changed == kCount);
      EXPECT_TRUE(same_bits<JointMatrix>(beside, made));
      unchanged = changed != kCount;
      EXPECT_EQ(run(JointPaletteJob{&skin, model, before, before, &unchanged}), ErrorCode::ok);
      EXPECT_EQ(unchanged, changed == kCount);
      EXPECT_TRUE(same_bits<JointMatrix>(before, made));
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
  EXPECT_EQ(run(JointPaletteJob{&skin, model, palette}), ErrorCode::ok);
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
  EXPECT_EQ(run(SplitPaletteJob{palette, split, &any}), ErrorCode::ok);
  EXPECT_TRUE(any);
  for (std::size_t i = 0; i < palette.size(); ++i) {
    EXPECT_TRUE(test::is_near(rebuilt(split[i]), affine_from(palette[i]), 1e-5)) << i;
    EXPECT_NEAR(safe_length(split[i].rigid.real), 1.0f, 1e-6f) << i;
  }
}

/// Matrices of every kind in turn: rigid, mirrored, stretched a little, much and far too much for lanes, flat, nothing,
/// not finite, and so large that the stretch is infinite in float.
std::vector<JointMatrix> matrices_of_every_kind(std::size_t count) {
  constexpr float kNone = 0.0f, kTiny = 1e-5f;
  const glm::vec3 scales[] = {{1, 1, 1},      {0.9f, 1.2f, 1}, {1, 1, 1}, {-1, 1, 1}, {2, 2, 2}, {1, kNone, 1},
                              {0.02f, 1, -1}, {kTiny, 1, 1},   {1, 1, 1}, {0, 0, 0},  {1, 1, 1}, {1, -1e-7f, 0.5f}};
  test::FixedRandom random(77);
  std::vector<JointMatrix> out;
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t kind = i % std::size(scales);
    Mat3<float> m = matrix_from_unit_quat(random.rotation<float>());
    for (int c = 0; c < 3; ++c) m[c] *= scales[kind][c];
    m = m * matrix_from_unit_quat(random.rotation<float>());
    if (kind == 8) m[1][2] = std::numeric_limits<float>::quiet_NaN();
    if (kind == 10) m = Mat3<float>(2, 2, -1, -1, 2, 2, 2, -1, 2) * 1.5e38f;
    out.push_back(joint_matrix_from(affine_from(m, random.vec3())));
  }
  return out;
}

TEST(split_palette, N27_N28_lanes_and_instruction_sets_give_each_matrix_the_same_bits) {
  const std::vector<JointMatrix> all = matrices_of_every_kind(36);
  std::vector<RigidStretch> alone(all.size());
  {
    const test::OnlyTarget only(test::simd_targets().back());
    for (std::size_t i = 0; i < all.size(); ++i)
      EXPECT_EQ(run(SplitPaletteJob{std::span(all).subspan(i, 1), {&alone[i], 1}}), ErrorCode::ok);
  }
  for (const std::int64_t target : test::simd_targets()) {
    const test::OnlyTarget only(target);
    for (std::size_t first = 0; first < 12; ++first)
      for (std::size_t count = 1; count <= 17; ++count) {
        std::vector<RigidStretch> split(count);
        EXPECT_EQ(run(SplitPaletteJob{std::span(all).subspan(first, count), split}), ErrorCode::ok);
        for (std::size_t i = 0; i < count; ++i)
          EXPECT_TRUE(same_bits(split[i], alone[first + i]))
              << first << ' ' << i << " of " << count << ' ' << test::simd_name(target);
      }
  }
}

/// Largest difference of the split from the decomposition in double precision: of the components of the quaternion,
/// and of the stretch relative to its largest entry. 1 is what rounding to float alone may do.
double roundings_from_double(const RigidStretch& split, const JointMatrix& matrix) {
  const auto truth = decompose_polar(Mat3<double>(linear_part(affine_from(matrix))));
  const auto& q = split.rigid.real;
  const double side = quat_dot(truth.quat, quat_cast<double>(q)) < 0.0 ? -1.0 : 1.0;
  double worst = 0.0, largest = 0.0;
  for (int c = 0; c < 4; ++c) worst = std::max(worst, std::abs(static_cast<double>(q[c]) - side * truth.quat[c]));
  for (const double s : truth.stretch) largest = std::max(largest, std::abs(s));
  for (int c = 0; c < 6; ++c)
    worst = std::max(worst, std::abs(static_cast<double>(split.stretch[c]) - truth.stretch[c]) / largest);
  return worst / test::kEps;
}

TEST(split_palette, N19_rotations_and_stretches_are_those_of_double_rounded_once) {
  test::FixedRandom random(21);
  for (const std::int64_t target : test::simd_targets()) {
    const test::OnlyTarget only(target);
    for (const double least : {1.0, 0.999999, 0.9995, 0.8, 0.3, 0.05, 0.01})
      for (const double size : {1e-18, 1.0, 1e15}) {
        std::vector<JointMatrix> palette;
        for (int i = 0; i < 200; ++i) {
          Mat3<double> d(0.0);
          for (int c = 0; c < 3; ++c) d[c][c] = (c == i % 5 ? -1 : 1) * random.in(least, 1.0) * size;
          palette.push_back(
              joint_matrix_from(affine_from(Mat3<float>(matrix_from_unit_quat(random.rotation<double>()) * d *
                                                        matrix_from_unit_quat(random.rotation<double>())),
                                            random.vec3())));
        }
        std::vector<RigidStretch> split(palette.size());
        EXPECT_EQ(run(SplitPaletteJob{palette, split}), ErrorCode::ok);
        for (std::size_t i = 0; i < palette.size(); ++i) {
          EXPECT_LE(roundings_from_double(split[i], palette[i]), 1.001) << least << ' ' << size << ' ' << i;
          EXPECT_EQ(determinant_sign(matrix_from_stretch(split[i].stretch)), determinant_sign(affine_from(palette[i])));
        }
      }
  }
}

TEST(split_palette, G48_stretches_have_the_side_of_their_matrix_however_flat_it_is) {
  test::FixedRandom random(48);
  std::vector<JointMatrix> palette;
  for (int i = 0; i < 1000; ++i) {
    const double least = std::pow(10.0, -i % 10) * (i % 20 < 10 ? 1 : -1);
    const Mat3<double> d(1.0, 0, 0, 0, random.in(0.1, 1.0), 0, 0, 0, i % 7 == 0 ? 0.0 : least);
    palette.push_back(joint_matrix_from(affine_from(Mat3<float>(matrix_from_unit_quat(random.rotation<double>()) * d *
                                                                matrix_from_unit_quat(random.rotation<double>())),
                                                    random.vec3())));
  }
  for (const std::int64_t target : test::simd_targets()) {
    const test::OnlyTarget only(target);
    std::vector<RigidStretch> split(palette.size());
    EXPECT_EQ(run(SplitPaletteJob{palette, split}), ErrorCode::ok);
    for (std::size_t i = 0; i < palette.size(); ++i) {
      const int sign = determinant_sign(affine_from(palette[i]));
      EXPECT_EQ(determinant_sign(matrix_from_stretch(split[i].stretch)) < 0, sign < 0) << i;
      EXPECT_TRUE(test::is_near(rebuilt(split[i]), affine_from(palette[i]), 1e-6)) << i;
    }
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
  EXPECT_EQ(run(SplitPaletteJob{palette, plain, nullptr, {}}), ErrorCode::ok);
  EXPECT_EQ(run(SplitPaletteJob{palette, split, nullptr, follow}), ErrorCode::ok);
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
  EXPECT_EQ(run(SplitPaletteJob{palette, split, &any}), ErrorCode::ok);
  EXPECT_FALSE(any);
  palette[7].column[2].z *= 1.01f;
  EXPECT_EQ(run(SplitPaletteJob{palette, split, &any}), ErrorCode::ok);
  EXPECT_TRUE(any);
  EXPECT_EQ(check(SplitPaletteJob{palette, std::span(split).first(3), &any}), ErrorCode::size_mismatch);
}

}  // namespace
}  // namespace sinew
