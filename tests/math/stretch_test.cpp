// SPDX-License-Identifier: MIT
#include "runtime/math/affine.h"

#include <gtest/gtest.h>

#include "runtime/math/transform.h"
#include "tests/support/fixed_random.h"

namespace sinew {
namespace {

TEST(stretch, of_rotations_with_uniform_scale_is_the_scale) {
  test::FixedRandom random(1);
  for (const double scale : {1e-3, 1.0, 250.0}) {
    const Transformd t{{1, 2, 3}, random.rotation<double>(), Vec3<double>(scale)};
    EXPECT_NEAR(largest_stretch(affine_from_transform(t)) / scale, 1.0, 1e-6);
  }
}

TEST(stretch, no_vector_becomes_longer) {
  test::FixedRandom random(2);
  for (int i = 0; i < 200; ++i) {
    const Affined m =
        affine_from_transform(random.transform<double>(-2, 2)) * affine_from_transform(random.transform<double>(-2, 2));
    const double bound = largest_stretch(m);
    double longest = 0;
    for (int k = 0; k < 50; ++k)
      longest = std::max(longest, safe_length(transform_vector(m, random.direction<double>())));
    EXPECT_LE(longest, bound * (1 + 1e-12));
    EXPECT_LE(bound, longest * 2.5);
  }
}

}  // namespace
}  // namespace sinew
