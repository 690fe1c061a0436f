// SPDX-License-Identifier: MIT
#include "runtime/math/scaling.h"

#include "runtime/math/matrix_rotation.h"
#include "runtime/math/shearing.h"
#include "tests/support/fixed_random.h"
#include "tests/support/near.h"

namespace sinew {
namespace {

using test::FixedRandom;
using test::is_near;

TEST(scaling, along_given_axes_stretches_each_axis_by_its_factor) {
  FixedRandom random(1);
  const auto frame = matrix_from_unit_quat(random.rotation<double>());
  const Vec3<double> s(2, -3, 0);
  const auto m = scaling_along(frame, s);
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(is_near(m * frame[i], frame[i] * s[i], 1e-14));
  EXPECT_TRUE(is_near(scaling(s) * Vec3<double>(1, 1, 1), s, 0));
}

TEST(scaling, along_one_axis_leaves_the_plane_square_to_it) {
  FixedRandom random(2);
  const auto frame = matrix_from_unit_quat(random.rotation<double>());
  const auto m = scaling_along(frame[2], 5.0);
  EXPECT_TRUE(is_near(m * frame[2], frame[2] * 5.0, 1e-14));
  EXPECT_TRUE(is_near(m * frame[0], frame[0], 1e-14));
}

TEST(shearing, each_of_six_moves_one_coordinate_by_another) {
  const struct {
    Shear kind;
    int changed, by;
  } rows[] = {{Shear::xy, 0, 1}, {Shear::xz, 0, 2}, {Shear::yx, 1, 0},
              {Shear::yz, 1, 2}, {Shear::zx, 2, 0}, {Shear::zy, 2, 1}};
  for (const auto& row : rows) {
    Vec3<double> p(1, 2, 4), expected = p;
    expected[row.changed] += 0.5 * p[row.by];
    EXPECT_EQ(shearing(row.kind, 0.5) * p, expected);
    EXPECT_EQ(shearing(row.kind, -0.5) * expected, p);
    EXPECT_EQ(glm::determinant(shearing(row.kind, 0.5)), 1);
  }
}

}  // namespace
}  // namespace sinew
