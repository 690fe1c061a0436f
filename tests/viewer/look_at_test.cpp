// SPDX-License-Identifier: MIT
#include "viewer/passes/look_at.h"

#include "runtime/math/inverse.h"
#include "tests/support/fixed_random.h"
#include "tests/support/near.h"

namespace sinew {
namespace {

using test::FixedRandom;
using test::is_near;

using V = Vec3<double>;

TEST(look_at, puts_the_eye_at_the_origin_and_the_target_ahead) {
  FixedRandom random(1);
  for (int i = 0; i < 100; ++i) {
    const V eye = random.vec3<double>(-5, 5), target = random.vec3<double>(-5, 5), up = random.direction<double>();
    const auto view = look_at(eye, target, up);
    EXPECT_TRUE(is_near(transform_point(view, eye), V(0), 1e-13));
    EXPECT_TRUE(is_near(transform_point(view, target), V(0, 0, -test::distance(eye, target)), 1e-13));
    const V up_seen = transform_vector(view, up);
    EXPECT_NEAR(up_seen.x, 0, 1e-12);
    EXPECT_GE(up_seen.y, 0);
    EXPECT_TRUE(is_near(view * inverse_rigid(view), Affined{}, 1e-13));
  }
}

TEST(look_at, up_along_the_view_or_no_view_at_all_still_gives_a_frame) {
  for (const V& target : {V(0, 0, 0), V(0, 5, 0), V(1, 2, 3)}) {
    const auto view = look_at(V(1, 2, 3), target, V(1, 2, 3) - target);
    EXPECT_TRUE(is_near(view * inverse_rigid(view), Affined{}, 1e-14));
    EXPECT_NEAR(determinant(view), 1, 1e-14);
  }
}

}  // namespace
}  // namespace sinew
