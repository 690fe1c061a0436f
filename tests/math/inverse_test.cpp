// SPDX-License-Identifier: MIT
#include "runtime/math/inverse.h"

#include "tests/support/fixed_random.h"
#include "tests/support/near.h"

namespace sinew {
namespace {

using test::FixedRandom;
using test::is_near;
using test::kEps;

TEST(inverse, rigid_motion_and_its_inverse_cancel) {
  FixedRandom random(1);
  for (int i = 0; i < 100; ++i) {
    Transform local = random.transform();
    local.scale = Vec3<float>(1);
    const auto m = affine_from_transform(local);
    EXPECT_TRUE(is_near(inverse_rigid(m) * m, Affine{}, 24 * kEps));
  }
}

TEST(inverse, transforms_with_scale_of_any_size_and_sign_cancel) {
  FixedRandom random(2);
  for (const double size : {1e-12, 1e-3, 1.0, 1e6}) {
    Transformd local = random.transform<double>(0.5 * size, 2 * size);
    local.scale.y = -local.scale.y;
    const auto m = affine_from_transform(local);
    const auto by_structure = inverse_of(local), by_adjoint = inverse_of(m);
    ASSERT_TRUE(by_structure && by_adjoint);
    EXPECT_TRUE(is_near(*by_structure * m, Affined{}, 1e-14 / std::min(size, 1.0) * std::max(size, 1.0)));
    EXPECT_TRUE(is_near(linear_part(*by_adjoint * m)[1], Vec3<double>(0, 1, 0), 1e-14)) << size;
  }
}

TEST(inverse, adjoint_inverts_sheared_matrices) {
  FixedRandom random(3);
  for (int i = 0; i < 100; ++i) {
    const auto a = affine_from_transform(random.transform<double>()),
               b = affine_from_transform(random.transform<double>());
    const auto m = a * b;
    const auto found = inverse_of(m);
    ASSERT_TRUE(found);
    EXPECT_TRUE(is_near(m * *found, Affined{}, 1e-13));
  }
}

TEST(inverse, G51_zero_scale_has_none_and_says_so) {
  FixedRandom random(4);
  for (int axis = 0; axis < 3; ++axis) {
    Transform local = random.transform();
    local.scale[axis] = 0;
    EXPECT_FALSE(inverse_of(local));
    EXPECT_FALSE(inverse_of(affine_from_transform(local)));
  }
  Affine flat = affine_from(Mat3<float>(1, 2, 3, 2, 4, 6, 0, 1, 0), Vec3<float>(0));
  EXPECT_FALSE(inverse_of(flat));
}

TEST(inverse, G48_an_inverse_never_mirrors_where_its_matrix_does_not) {
  FixedRandom random(6);
  int found = 0, none = 0;
  for (int i = 0; i < 20000; ++i) {
    Mat3<float> m(random.vec3(), random.vec3(), random.vec3());
    m[2] = m[0] * 0.7f + m[1] * 0.9f + random.vec3() * 4e-7f;  // singular within rounding, or slightly beyond
    const auto inverse = inverse_of(affine_from(m, Vec3<float>(0)));
    if (inverse) {
      EXPECT_EQ(determinant_sign(*inverse), determinant_sign(m)) << i;
    }
    ++(inverse ? found : none);
  }
  EXPECT_GT(found, 100);
  EXPECT_GT(none, 100);
}

}  // namespace
}  // namespace sinew
