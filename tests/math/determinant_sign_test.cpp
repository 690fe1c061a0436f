// SPDX-License-Identifier: MIT
#include "runtime/math/determinant_sign.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "runtime/math/matrix_rotation.h"
#include "tests/support/fixed_random.h"

namespace sinew {
namespace {

using test::FixedRandom;

/// An exact sum of products of three floats, as an integer multiple of 2^-520. 40 limbs hold any such sum.
class WholeSum {
 public:
  void add_product(float a, float b, float c, int sign) {
    int exponent = 520;
    __int128 product = sign;
    for (const float factor : {a, b, c}) {
      int e = 0;
      const float mantissa = std::frexp(factor, &e);
      product *= static_cast<std::int32_t>(std::ldexp(mantissa, 24));
      exponent += factor == 0.0f ? 0 : e - 24;
    }
    const bool negative = product < 0;
    unsigned __int128 left = static_cast<unsigned __int128>(negative ? -product : product) << exponent % 32;
    for (std::size_t limb = static_cast<std::size_t>(exponent) / 32; left != 0; ++limb, left >>= 32)
      limbs_.at(limb) += static_cast<std::int64_t>(left & 0xffffffffu) * (negative ? -1 : 1);
  }
  int sign() {
    std::int64_t carry = 0;
    bool any = false;
    for (std::int64_t& limb : limbs_) {
      limb += carry;
      carry = limb >> 32;  // arithmetic shift: rounds down
      limb &= 0xffffffff;
      any |= limb != 0;
    }
    return carry < 0 ? -1 : any;
  }

 private:
  std::array<std::int64_t, 40> limbs_ = {};
};

int exact_sign(const Mat3<float>& m) {
  WholeSum sum;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    sum.add_product(m[0][i], m[1][j], m[2][k], 1);
    sum.add_product(m[0][i], m[1][k], m[2][j], -1);
  }
  return sum.sign();
}

/// Sign of the determinant in plain float arithmetic.
int plain_sign(const Mat3<float>& m) {
  const float determinant = glm::dot(m[0], glm::cross(m[1], m[2]));
  return (determinant > 0.0f) - (determinant < 0.0f);
}

Mat3<float> with_singular_values(FixedRandom& random, const Vec3<double>& values) {
  Mat3<double> d(0.0);
  for (int i = 0; i < 3; ++i) d[i][i] = values[i];
  return Mat3<float>(matrix_from_unit_quat(random.rotation<double>()) * d *
                     matrix_from_unit_quat(random.rotation<double>()));
}

/// A matrix of small integers whose third column is a combination of the others, so it is exactly singular.
Mat3<float> singular(FixedRandom& random) {
  const auto whole = [&] { return static_cast<float>(random.below(2001)) - 1000.0f; };
  Mat3<float> m(whole(), whole(), whole(), whole(), whole(), whole(), 0, 0, 0);
  m[2] = m[0] * std::round(whole() / 100) + m[1] * std::round(whole() / 100);
  return m;
}

float any_finite(FixedRandom& random, std::uint32_t least_exponent, std::uint32_t exponents) {
  const auto bits = static_cast<std::uint32_t>(random.bits());
  return std::bit_cast<float>((bits & 0x807fffffu) | (least_exponent + random.below(exponents)) << 23);
}

TEST(determinant_sign, G48_is_exact_for_matrices_of_any_condition) {
  FixedRandom random(1);
  int wrong_in_float = 0;
  for (int i = 0; i < 4000; ++i) {
    Vec3<double> values;
    for (int c = 0; c < 3; ++c) values[c] = std::pow(10.0, random.in(-12, 12)) * (random.below(2) ? 1 : -1);
    if (i < 1000) values = {1e3, 1e-3, i % 2 ? 1e-3 : -1e-3};
    const Mat3<float> m = with_singular_values(random, values);
    EXPECT_EQ(determinant_sign(m), exact_sign(m)) << i;
    wrong_in_float += plain_sign(m) != exact_sign(m);
  }
  EXPECT_GT(wrong_in_float, 400) << "the matrices are hard enough";
}

TEST(determinant_sign, is_zero_for_singular_matrices_alone) {
  FixedRandom random(2);
  for (int i = 0; i < 2000; ++i) {
    Mat3<float> m = singular(random);
    EXPECT_EQ(determinant_sign(m), 0) << i;
    EXPECT_EQ(determinant_sign(m * 0x1p-120f), 0) << i;
    float& entry = m[static_cast<int>(random.below(3))][static_cast<int>(random.below(3))];
    entry = std::nextafter(entry, random.below(2) ? 1e9f : -1e9f);
    EXPECT_EQ(determinant_sign(m), exact_sign(m)) << i;
  }
  EXPECT_EQ(determinant_sign(Mat3<float>(0.0f)), 0);
  EXPECT_EQ(determinant_sign(Mat3<float>(1.0f)), 1);
}

TEST(determinant_sign, is_exact_for_denormal_and_huge_entries_and_all_between) {
  FixedRandom random(3);
  const struct { std::uint32_t least_exponent, exponents; } ranges[] = {{0, 1}, {0, 3}, {252, 3}, {120, 10}, {0, 255}};
  for (const auto& range : ranges)
    for (int i = 0; i < 2000; ++i) {
      Mat3<float> m;
      for (int e = 0; e < 9; ++e) m[e / 3][e % 3] = any_finite(random, range.least_exponent, range.exponents);
      if (i % 3 == 1) m[2] = m[1];
      if (i % 3 == 2) {
        m[2] = m[0];
        m[2][i % 2] = std::nextafter(m[2][i % 2], 0.0f);
      }
      EXPECT_EQ(determinant_sign(m), exact_sign(m)) << range.least_exponent << ' ' << i;
    }
  const float most = std::numeric_limits<float>::max(), least = std::numeric_limits<float>::denorm_min();
  EXPECT_EQ(determinant_sign(Mat3<float>(most)), 1);
  EXPECT_EQ(determinant_sign(Mat3<float>(-least)), -1);
}

/// eq   det(M + d e_ij) = d cof_ij for a singular M
TEST(determinant_sign, of_doubles_sees_the_last_digit_of_one_entry_at_any_scale) {
  FixedRandom random(4);
  for (int i = 0; i < 2000; ++i) {
    const Mat3<double> m(singular(random));
    const int column = static_cast<int>(random.below(3)), row = static_cast<int>(random.below(3));
    if (m[column][row] == 0.0)
      continue;  // the next double would be 1e-300 of the others, and scaling would round it to 0
    const auto &next = m[(column + 1) % 3], &last = m[(column + 2) % 3];
    const double cofactor = glm::cross(next, last)[row];
    Mat3<double> moved = m;
    moved[column][row] = std::nextafter(m[column][row], 1e9);
    for (const double scale : {1.0, 0x1p-250, 0x1p250}) {
      Mat3<double> scaled = moved;
      for (int c = 0; c < 3; ++c) scaled[c] *= c == 1 ? scale : 1.0;
      EXPECT_EQ(determinant_sign(scaled), (cofactor > 0) - (cofactor < 0)) << i << ' ' << scale;
      EXPECT_EQ(determinant_sign(-scaled), (cofactor < 0) - (cofactor > 0)) << i << ' ' << scale;
    }
  }
}

TEST(determinant_sign, of_an_affine_matrix_is_that_of_its_linear_part) {
  FixedRandom random(5);
  Transform local = random.transform();
  EXPECT_EQ(determinant_sign(affine_from_transform(local)), 1);
  local.scale.z = -local.scale.z;
  EXPECT_EQ(determinant_sign(affine_from_transform(local)), -1);
  EXPECT_EQ(determinant_sign(affine_cast<double>(affine_from_transform(local))), -1);
}

}  // namespace
}  // namespace sinew
