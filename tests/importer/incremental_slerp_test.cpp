// SPDX-License-Identifier: MIT
#include "importer/tool/cost/rotation/incremental_slerp.h"

#include "tests/support/fixed_random.h"
#include "tests/support/near.h"

namespace sinew::cost {
namespace {

using test::FixedRandom;
using test::kEps;

TEST(incremental_slerp, steps_agree_with_slerp_all_the_way) {
  FixedRandom random(1);
  for (const int steps : {1, 2, 7, 1000, 100000}) {
    const auto q = random.rotation(), r = random.rotation();
    const auto qd = normalised(quat_cast<double>(q)), rd = normalised(quat_cast<double>(r));
    IncrementalSlerp<float> walk(q, r, steps);
    double worst = 0;
    for (int k = 0; k <= steps; ++k, walk.advance())
      worst = std::max(worst, test::angle_between(walk.current(), slerp_short_arc(qd, rd, double(k) / steps)));
    EXPECT_LE(worst, 4 * kEps) << steps;
  }
}

TEST(incremental_slerp, equal_keys_stay_where_they_are) {
  FixedRandom random(2);
  const auto q = random.rotation();
  IncrementalSlerp<float> walk(q, -q, 10);
  for (int k = 0; k < 10; ++k) walk.advance();
  EXPECT_TRUE(test::same_rotation(walk.current(), q, 4 * kEps));
}

TEST(incremental_slerp, tiny_arcs_are_not_lost) {
  FixedRandom random(3);
  const auto q = random.rotation<double>(), r = q * random.rotation_by<double>(1e-7);
  IncrementalSlerp<double> walk(q, r, 1000);
  for (int k = 0; k < 500; ++k) walk.advance();
  EXPECT_NEAR(test::angle_between(q, walk.current()), 0.5e-7, 3e-14);  // 500 random roundings of 1e-16
}

}  // namespace
}  // namespace sinew::cost
