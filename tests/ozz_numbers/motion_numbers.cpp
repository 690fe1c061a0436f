// SPDX-License-Identifier: MIT
// Blends of root motion. sinew's weights are at least 0: the caller leaves out a motion that ozz drops.
#include <vector>

#include "runtime/playback/root_motion.h"
#include "tests/ozz_numbers/tally.h"

namespace sinew::ozz {
namespace {

struct MotionCase {
  glm::dvec3 first, second;  // translations
  double weight, other_weight;
  glm::dvec3 expected;
  glm::dquat turn;  // x, y, z, w by quat_xyzw
};

constexpr double kHalf = 0.70710677;
constexpr const char* kLinear =
    "blend_root_motion takes the mean of translations, ozz blends directions and lengths apart";

}  // namespace

Tally motion_blending_group() {
  const Quat<double> none = quat_identity<double>(), first = quat_xyzw(kHalf, 0.0, 0.0, kHalf),
                     second = quat_xyzw(0.0, -kHalf, 0.0, -kHalf),
                     mean = quat_xyzw(0.6172133, 0.1543033, 0.0, 0.7715167);
  const glm::dvec3 x(2, 0, 0), z(0, 0, 3), zero(0.0), blended(2.134313, 0, 0.533578);
  const MotionCase cases[] = {{x, z, 0.0, 0.0, zero, none},
                              {x, z, 0.8, 0.0, x, first},
                              {x, z, 0.8, 0.2, blended, mean},
                              {x, z, 8.0, 2.0, blended, mean},
                              {x, z, 0.08, 0.02, blended, mean},
                              {zero, {0, 0, 2}, 0.8, 0.2, {0, 0, 0.4}, mean},
                              {{0, 0, -2}, {0, 0, 2}, 1.0, 1.0, zero, quat_xyzw(0.408248, 0.408248, 0.0, 0.816496)}};
  Tally tally;
  for (const MotionCase& c : cases) {
    const RootShare shares[] = {{dual_quat_from(first, c.first), {}, c.weight},
                                {dual_quat_from(second, c.second), {}, c.other_weight}};
    const DualQuatd motion = blend_root_motion(shares).motion;
    const glm::dvec3 moved = translation_of(motion);
    for (int axis = 0; axis < 3; ++axis) compare(moved[axis], c.expected[axis], kTolerance, tally, kLinear);
    compare_rotation(motion.real, c.turn, tally);
  }
  return tally;
}

}  // namespace sinew::ozz
