// SPDX-License-Identifier: MIT
#include "runtime/math/dual_quaternion.h"

#include "runtime/math/transform.h"
#include "tests/support/fixed_random.h"
#include "tests/support/near.h"

namespace sinew {
namespace {

using test::FixedRandom;
using test::is_near;
using test::kEps;
using test::same_rotation;

DualQuatd random_motion(FixedRandom& random) {
  return dual_quat_from(random.rotation<double>(), random.vec3<double>(-3, 3));
}

TEST(dual_quaternion, moves_points_as_its_rotation_and_translation_do) {
  FixedRandom random(1);
  for (int i = 0; i < 100; ++i) {
    const auto q = random.rotation<double>();
    const auto t = random.vec3<double>(-3, 3), p = random.vec3<double>();
    const auto motion = dual_quat_from(q, t);
    EXPECT_TRUE(is_near(translation_of(motion), t, 1e-14));
    EXPECT_TRUE(is_near(transform_point(motion, p), rotate_vector(q, p) + t, 1e-14));
    EXPECT_TRUE(is_near(transform_vector(motion, p), rotate_vector(q, p), 1e-14));
    TransformT<double> local;
    local.translation = t;
    local.rotation = q;
    EXPECT_TRUE(is_near(affine_from_dual_quat(motion), affine_from_transform(local), 1e-14));
  }
}

TEST(dual_quaternion, product_chains_motions_right_factor_first) {
  FixedRandom random(2);
  for (int i = 0; i < 100; ++i) {
    const auto a = random_motion(random), b = random_motion(random);
    const auto p = random.vec3<double>();
    EXPECT_TRUE(is_near(transform_point(a * b, p), transform_point(a, transform_point(b, p)), 1e-13));
  }
}

TEST(dual_quaternion, conjugate_is_the_inverse_motion) {
  FixedRandom random(3);
  const auto a = random_motion(random);
  EXPECT_TRUE(is_near(affine_from_dual_quat(dual_quat_conjugate(a) * a), Affined{}, 1e-14));
}

TEST(dual_quaternion, normalised_removes_length_and_what_lies_along_the_real_part) {
  FixedRandom random(4);
  const auto a = random_motion(random);
  const DualQuatd bent{a.real * 7.0, (a.dual + a.real * 0.3) * 7.0};
  const auto unit = normalised(bent);
  EXPECT_NEAR(quat_dot(unit.real, unit.real), 1, 1e-15);
  EXPECT_NEAR(quat_dot(unit.real, unit.dual), 0, 1e-15);
  EXPECT_TRUE(is_near(affine_from_dual_quat(unit), affine_from_dual_quat(a), 1e-14));
  const DualQuat cancelled{quat_xyzw(0.f, 0.f, 0.f, 0.f), quat_xyzw(1.f, 2.f, 3.f, 4.f)};
  EXPECT_TRUE(is_near(affine_from_dual_quat(normalised(cancelled)), Affine{}, 0));
}

}  // namespace
}  // namespace sinew
