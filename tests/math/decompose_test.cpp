// SPDX-License-Identifier: MIT
#include "runtime/math/decompose.h"

#include <limits>

#include "runtime/math/determinant_sign.h"
#include "runtime/math/matrix_rotation.h"
#include "tests/support/fixed_random.h"
#include "tests/support/near.h"

namespace sinew {
namespace {

using test::FixedRandom;
using test::is_near;
using test::kEps;
using test::same_rotation;

template <class T>
void expect_polar(const Mat3<T>& m, const PolarT<T>& p, double tolerance) {
  const Mat3<double> r(p.rotation), s(matrix_from_stretch(p.stretch)), product = r * s, square = glm::transpose(r) * r;
  for (int c = 0; c < 3; ++c) {
    EXPECT_LE(test::distance(product[c], Vec3<double>(m[c])), tolerance);
    EXPECT_LE(test::distance(square[c], Mat3<double>(1.0)[c]), 8 * kEps);
  }
  EXPECT_GT(glm::determinant(r), 0.5);
  EXPECT_TRUE(same_rotation(p.quat, quat_from_matrix(r), 8 * kEps));
}

TEST(decompose, polar_finds_the_rotation_and_the_symmetric_stretch) {
  FixedRandom random(1);
  for (int i = 0; i < 100; ++i) {
    const auto q = random.rotation<double>(), axes = random.rotation<double>();
    const auto r = matrix_from_unit_quat(q), v = matrix_from_unit_quat(axes);
    Mat3<double> d(1.0);
    for (int c = 0; c < 3; ++c) d[c][c] = random.in(0.2, 3);
    const auto m = r * (v * d * glm::transpose(v));
    const auto p = decompose_polar(m);
    EXPECT_EQ(p.status, DecomposeStatus::ok);
    EXPECT_TRUE(same_rotation(p.quat, q, 1e-13));
    expect_polar(m, p, 1e-13);
  }
}

TEST(decompose, N16_polar_of_a_reflection_is_a_rotation_times_a_negative_stretch) {
  const Mat3<float> m(-2, 0, 0, 0, 3, 0, 0, 0, 4);
  const auto p = decompose_polar(m);
  EXPECT_EQ(p.status, DecomposeStatus::mirrored);
  expect_polar(m, p, 16 * kEps);
  EXPECT_TRUE(same_rotation(p.quat, quat_xyzw(1.f, 0.f, 0.f, 0.f), 4 * kEps));
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(p.stretch[i], -(2.0 + i), 16 * kEps);
}

TEST(decompose, N16_polar_of_singular_matrices_still_rebuilds_and_says_so) {
  FixedRandom random(2);
  for (int rank = 0; rank < 3; ++rank)
    for (int i = 0; i < 1000; ++i) {
      Mat3<float> d(0.f);
      for (int c = 0; c < rank; ++c) d[c][c] = static_cast<float>(random.in(0.5, 2));
      const auto left = random.rotation<double>(), right = random.rotation<double>();
      const auto m = Mat3<float>(matrix_from_unit_quat(left) * Mat3<double>(d) * matrix_from_unit_quat(right));
      const auto p = decompose_polar(m);
      EXPECT_EQ(p.status, DecomposeStatus::singular);
      expect_polar(m, p, 20 * kEps);
    }
  EXPECT_EQ(decompose_polar(Mat3<float>(0.f)).quat, quat_identity<float>());
}

TEST(decompose, G48_the_stretch_keeps_the_sign_of_the_determinant_in_spite_of_rounding) {
  FixedRandom random(8);
  for (int i = 0; i < 1000; ++i) {
    const double least = std::pow(10.0, -1 - i % 10) * (i % 20 < 10 ? 1 : -1);
    Mat3<double> d(0.0);
    d[0][0] = 1e3;
    d[1][1] = 1.0;
    d[2][2] = i % 7 == 0 ? 0.0 : least;
    const Mat3<float> m(matrix_from_unit_quat(random.rotation<double>()) * d *
                        matrix_from_unit_quat(random.rotation<double>()));
    const auto p = decompose_polar(m);
    EXPECT_EQ(determinant_sign(matrix_from_stretch(p.stretch)), determinant_sign(m)) << i;
    if (p.status != DecomposeStatus::singular) {
      EXPECT_EQ(determinant_sign(m), p.status == DecomposeStatus::mirrored ? -1 : 1) << i;
    }
    expect_polar(m, p, 16 * kEps * 1e3);
    const auto trs = decompose_trs(affine_from(m, Vec3<float>(0)));
    EXPECT_EQ(trs.transform.scale.x < 0.0f, determinant_sign(m) < 0) << i;
  }
}

TEST(decompose, N16_with_rank_one_noise_does_not_decide_the_free_rotation) {
  FixedRandom random(16);
  for (int i = 0; i < 100; ++i) {
    Mat3<float> m(0.0f);
    m[0] = {1.0f, 0.0f, 0.0f};
    for (int c = 1; c < 3; ++c) m[c] = random.direction() * 1e-9f;
    EXPECT_LE(test::angle_between(decompose_polar(m).quat, quat_identity<double>()), 1e-6);
  }
}

TEST(decompose, N16_polar_of_not_finite_input_is_the_identity_with_a_status) {
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row)
      for (const float wrong : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        Mat3<float> m(1.0f);
        m[column][row] = wrong;
        EXPECT_EQ(decompose_polar(m).status, DecomposeStatus::not_finite) << column << ' ' << row;
        EXPECT_EQ(decompose_polar(m).quat, quat_identity<float>());
      }
}

TEST(decompose, N16_trs_of_not_finite_input_is_unturned_with_a_status) {
  for (const float wrong : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    Affine m;
    m.row[1][2] = wrong;
    const auto found = decompose_trs(m);
    EXPECT_EQ(found.status, DecomposeStatus::not_finite) << wrong;
    EXPECT_EQ(found.transform.rotation, quat_identity<float>());
    EXPECT_EQ(found.transform.scale, glm::vec3(1.0f));
  }
}

TEST(decompose, N15_trs_holds_at_every_size_of_scale) {
  FixedRandom random(3);
  for (const double size : {1e-30, 1e-10, 1e-3, 1.0, 1e10, 1e30}) {
    Transform local = random.transform(0.5 * size, 2 * size);
    const auto found = decompose_trs(affine_from_transform(local));
    EXPECT_EQ(found.status, DecomposeStatus::ok) << size;
    EXPECT_TRUE(same_rotation(found.transform.rotation, local.rotation, 16 * kEps)) << size;
    EXPECT_TRUE(
        is_near(found.transform.scale / static_cast<float>(size), local.scale / static_cast<float>(size), 16 * kEps));
    EXPECT_EQ(found.transform.translation, local.translation);
  }
}

TEST(decompose, N15_mirroring_on_any_axis_is_carried_by_scale_x) {
  FixedRandom random(4);
  for (int axis = 0; axis < 3; ++axis) {
    Transform local = random.transform();
    local.scale[axis] = -local.scale[axis];
    const auto m = affine_from_transform(local);
    const auto found = decompose_trs(m);
    EXPECT_EQ(found.status, DecomposeStatus::mirrored);
    EXPECT_LT(found.transform.scale.x, 0.f);
    EXPECT_GT(found.transform.scale.y, 0.f);
    EXPECT_TRUE(is_near(affine_from_transform(found.transform), m, 16 * kEps));
  }
}

TEST(decompose, trs_reports_shear_and_flat_axes) {
  Affine sheared;
  sheared.row[0].y = 0.5f;
  EXPECT_EQ(decompose_trs(sheared).status, DecomposeStatus::sheared);
  sheared.row[0].y = 1e-4f;
  EXPECT_EQ(decompose_trs(sheared).status, DecomposeStatus::sheared) << "however little";
  sheared.row[0].y = 1e-6f;
  EXPECT_EQ(decompose_trs(sheared).status, DecomposeStatus::ok) << "which is rounding";
  FixedRandom random(5);
  for (int flat = 0; flat < 8; ++flat) {
    Transform local = random.transform();
    for (int axis = 0; axis < 3; ++axis)
      if (flat & (1 << axis)) local.scale[axis] = 0.f;
    const auto m = affine_from_transform(local);
    const auto found = decompose_trs(m);
    EXPECT_EQ(found.status == DecomposeStatus::singular, flat != 0);
    EXPECT_TRUE(is_near(affine_from_transform(found.transform), m, 16 * kEps)) << flat;
  }
}

}  // namespace
}  // namespace sinew
