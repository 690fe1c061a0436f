// SPDX-License-Identifier: MIT
// Joints turn through 720 degrees in small steps. The skin must move continuously, except when two joints of a vertex
// pass a relative half turn: there the shorter way changes.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "runtime/math/matrix_rotation.h"
#include "tests/reference/skinning.h"
#include "tests/support/near.h"
#include "tests/support/skinning_ways.h"

namespace sinew {
namespace {

using test::Way;
using Vec3d = Vec3<double>;

constexpr std::uint32_t kSweepCounts[] = {2, 3, 4, 6};
constexpr std::uint32_t kSweepJoints = 7;
constexpr int kSteps = 1440;
constexpr double kStep_rad = 3.141592653589793 / 360;  // 720 degrees in all
/// Times are half a step away from the half turns, where rounding would decide which way is shorter.
constexpr double time_at(int step) { return (step + 0.5) * kStep_rad; }
constexpr double kRounding = 5e-5;  // of float positions a few metres from the origin

/// A joint that turns about its own axis by `angle_rad(s)` after s radians of the sweep, at most `speed` per radian.
struct Turning {
  Vec3d axis, pivot;
  double speed = 0.0, sway_rad = 0.0;  ///< sway_rad > 0: sways back and forth within this angle

  double angle_rad(double s) const { return sway_rad > 0.0 ? sway_rad * std::sin(s * speed / sway_rad) : s * speed; }
  /// Continuous in s, without sign changes.
  Quat<double> rotation(double s) const {
    const Vec3d v = axis * std::sin(angle_rad(s) / 2);
    return quat_xyzw(v.x, v.y, v.z, std::cos(angle_rad(s) / 2));
  }
  Vec3d move(double s, const Vec3d& p) const { return pivot + rotate_vector(rotation(s), p - pivot); }
  Affined matrix(double s) const {
    const auto m = matrix_from_unit_quat(rotation(s));
    return affine_from(m, pivot - m * pivot);
  }
};

/// The joints of one vertex over one step.
struct Step {
  std::vector<const Turning*> joints;
  std::vector<double> weights;
  double from = 0.0, to = 0.0;

  double length() const { return to - from; }

  /// True if a joint and the heaviest joint pass a relative half turn within the step.
  bool passes_half_turn() const {
    for (const Turning* joint : joints)
      if (side(*joint, from) != side(*joint, to)) return true;
    return false;
  }

  /// eq   |M(to) p - M(from) p| <= sum(w |turn_i| |p - pivot_i|)
  double linear_bound(const Vec3d& p) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < joints.size(); ++i)
      sum += weights[i] * joints[i]->speed * length() * glm::length(p - joints[i]->pivot);
    return sum;
  }

  /// Bounds the change of the unit rotation b / |b| as a 4-vector: |b'| / |b|, b' = sum(w turn_i / 2).
  double rotation_bound() const { return blend_step() / shortest(); }

  /// Bounds the movement of p. Let p be the origin of rest space and the pivot joint's image of p the origin of the
  /// world. Then the blended motion takes p to 2 b_d b*/|b|^2, b_d = sum(w u_i q_i / 2), u_i = the image of p by joint
  /// i.
  /// eq   |p''| <= 2 |b_d'| / |b| + 2 |b_d| |b'| / |b|^2
  double dual_bound(const Vec3d& p) const {
    const Vec3d origin = joints[0]->move(from, p);
    double dual = 0.0, dual_step = 0.0;
    for (std::size_t i = 0; i < joints.size(); ++i) {
      const double step = joints[i]->speed * length(), moved = step * glm::length(p - joints[i]->pivot);
      const double reach = glm::length(joints[i]->move(from, p) - origin) + moved;
      dual += weights[i] * reach / 2;
      dual_step += weights[i] * (moved + reach * step / 2) / 2;
    }
    return 2 * dual_step / shortest() + 2 * dual * blend_step() / (shortest() * shortest());
  }

 private:
  bool side(const Turning& joint, double s) const { return quat_dot(joint.rotation(s), joints[0]->rotation(s)) < 0.0; }

  double blend_step() const {
    double sum = 0.0;
    for (std::size_t i = 0; i < joints.size(); ++i) sum += weights[i] * joints[i]->speed * length() / 2;
    return sum;
  }

  /// A lower bound for the length of the blend within the step.
  double shortest() const {
    const auto at = [&](double s) {
      std::vector<DualQuatd> motions;
      for (const Turning* joint : joints) motions.push_back(dual_quat_from(joint->rotation(s), Vec3d(0)));
      return reference::blend_motions<double>(motions, weights).length;
    };
    return std::min(at(from), at(to)) - blend_step();
  }
};

double bound_of(Way way, const Step& step, const Vec3d& p, const Vec3d& center) {
  if (way == Way::dual_quaternion) return step.dual_bound(p);
  if (way == Way::center_of_rotation)
    return 2 * step.rotation_bound() * glm::length(p - center) + step.linear_bound(center);
  return step.linear_bound(p);
}

struct Sweep {
  std::vector<Turning> joints;
  test::SkinnedVertices s;
  std::vector<glm::vec3> centers;

  explicit Sweep(test::FixedRandom& random)
      : s(test::random_skinned_vertices(random, kSweepCounts, 6, kSweepJoints, false)) {
    for (std::uint32_t j = 0; j < kSweepJoints; ++j)
      joints.push_back({random.direction<double>(), random.vec3<double>(), 1.0, 0.0});
    for (const glm::vec3& p : s.positions) centers.push_back(p + random.vec3());
  }

  Step step_of(std::size_t v, int step) const {
    Step out{{}, {}, time_at(step - 1), time_at(step)};
    for (const auto j : s.joints_of(v)) out.joints.push_back(&joints[j]);
    for (const float w : s.weights_of(v)) out.weights.push_back(static_cast<double>(w));
    return out;
  }

  /// Counts of a sweep: steps over the bound without and with a passed half turn, and passed half turns.
  struct Outcome {
    int unexplained = 0, leaps = 0, half_turns = 0;
  };

  Outcome run(Way way) {
    Outcome outcome;
    std::vector<glm::vec3> last;
    for (int step = 0; step <= kSteps; ++step) {
      for (std::uint32_t j = 0; j < kSweepJoints; ++j)
        s.palette[j] = joint_matrix_from(affine_cast<float>(joints[j].matrix(time_at(step))));
      skin(way, s, centers);
      for (std::size_t v = 0; v < last.size(); ++v) count(way, step_of(v, step), v, last[v], outcome);
      last = s.out_positions;
    }
    return outcome;
  }

 private:
  void count(Way way, const Step& step, std::size_t v, const glm::vec3& last, Outcome& outcome) const {
    const bool half_turn = step.passes_half_turn();
    outcome.half_turns += half_turn;
    const double moved = test::distance(Vec3d(s.out_positions[v]), Vec3d(last));
    if (moved <= bound_of(way, step, Vec3d(s.positions[v]), Vec3d(centers[v])) + kRounding) return;
    ++(half_turn ? outcome.leaps : outcome.unexplained);
  }
};

class SkinningContinuity : public testing::TestWithParam<Way> {};

TEST_P(SkinningContinuity, N18_the_skin_moves_continuously_except_at_half_turns) {
  test::FixedRandom random(31);
  Sweep sweep(random);
  for (std::uint32_t j = 0; j < kSweepJoints; ++j) sweep.joints[j].speed = j % 3 == 0 ? 0.0 : random.in(0.5, 1.0);
  sweep.joints[1].speed = 1.0;
  const Sweep::Outcome outcome = sweep.run(GetParam());
  EXPECT_EQ(outcome.unexplained, 0);
  EXPECT_GT(outcome.half_turns, 20);
  const bool blends_rotations = GetParam() == Way::dual_quaternion || GetParam() == Way::center_of_rotation;
  if (blends_rotations) {
    EXPECT_GT(outcome.leaps, 20) << "the documented exception";
  } else {
    EXPECT_EQ(outcome.leaps, 0);
  }
}

TEST_P(SkinningContinuity, N17_a_body_turned_twice_with_joints_that_sway_below_a_half_turn_never_leaps) {
  test::FixedRandom random(32);
  Sweep sweep(random);
  const Vec3d axis = random.direction<double>();
  for (Turning& joint : sweep.joints) {
    joint.axis = axis;
    joint.speed = 1.0;  // a whole turn, so its quaternion changes sign
    joint.pivot = Vec3d(0);
  }
  for (std::uint32_t j = 0; j < kSweepJoints; j += 2) sweep.joints[j].speed = 0.8;  // 144 degrees behind at the end
  const Sweep::Outcome outcome = sweep.run(GetParam());
  EXPECT_EQ(outcome.half_turns, 0);
  EXPECT_EQ(outcome.unexplained, 0);
}

TEST_P(SkinningContinuity, N17_joints_that_sway_by_85_degrees_about_any_axes_never_leap) {
  test::FixedRandom random(33);
  Sweep sweep(random);
  for (Turning& joint : sweep.joints) {
    joint.speed = random.in(0.5, 1.0);
    joint.sway_rad = 85 * 3.141592653589793 / 180;
  }
  const Sweep::Outcome outcome = sweep.run(GetParam());
  EXPECT_EQ(outcome.half_turns, 0);
  EXPECT_EQ(outcome.unexplained, 0);
}

INSTANTIATE_TEST_SUITE_P(kinds, SkinningContinuity,
                         testing::Values(Way::linear, Way::dual_quaternion, Way::center_of_rotation),
                         testing::PrintToStringParamName());

}  // namespace
}  // namespace sinew
