// SPDX-License-Identifier: MIT
#include "runtime/math/matrix_rotation.h"

#include "tests/support/fixed_random.h"
#include "tests/support/near.h"

namespace sinew {
namespace {

using test::FixedRandom;
using test::is_near;
using test::kEps;
using test::same_rotation;

TEST(matrix_rotation, N12_round_trip_holds_on_all_four_branches) {
  FixedRandom random(1);
  int taken[4] = {};
  for (int i = 0; i < 2000; ++i) {
    const auto q = random.rotation();
    int largest = 0;
    for (int c = 1; c < 4; ++c)
      if (std::abs(q[c]) > std::abs(q[largest])) largest = c;
    ++taken[largest];
    EXPECT_TRUE(same_rotation(quat_from_matrix(matrix_from_unit_quat(q)), q, 10 * kEps));
  }
  for (const int count : taken) EXPECT_GT(count, 200);
}

TEST(matrix_rotation, N12_half_turns_and_ties_are_exact) {
  for (int axis = 0; axis < 3; ++axis) {
    Mat3<float> m(-1.f);
    m[axis][axis] = 1;
    Quat<float> q = quat_xyzw(0.f, 0.f, 0.f, 0.f);
    q[axis] = 1;
    EXPECT_TRUE(same_rotation(quat_from_matrix(m), q, 0));
  }
  const Mat3<float> cycle(0, 1, 0, 0, 0, 1, 1, 0, 0);  // all four components are 0.5
  EXPECT_TRUE(same_rotation(quat_from_matrix(cycle), quat_xyzw(0.5f, 0.5f, 0.5f, 0.5f), 0));
}

TEST(matrix_rotation, matrix_rotates_as_the_quaternion_does) {
  FixedRandom random(2);
  for (int i = 0; i < 100; ++i) {
    const auto q = random.rotation<double>();
    const auto p = random.vec3<double>();
    EXPECT_TRUE(is_near(matrix_from_unit_quat(q) * p, rotate_vector(q, p), 1e-14));
    EXPECT_TRUE(is_near(matrix_from_quat(q * 1e20) * p, rotate_vector(q, p), 1e-14));
  }
}

}  // namespace
}  // namespace sinew
