// SPDX-License-Identifier: MIT
#include "tests/reference/skinning.h"

#include <vector>

#include "runtime/math/transform.h"
#include "tests/support/fixed_random.h"
#include "tests/support/near.h"

namespace sinew {
namespace {

using reference::blend_motions;
using reference::skin_center_of_rotation;
using reference::skin_dual_quaternion;
using reference::skin_linear;
using test::is_near;

constexpr double kPi = 3.141592653589793;

/// Two bones: one at rest, one turned about x.
struct Twist {
  explicit Twist(double angle_rad)
      : motions{{},
                dual_quat_from(quat_xyzw(std::sin(angle_rad / 2), 0.0, 0.0, std::cos(angle_rad / 2)), Vec3<double>(0))},
        matrices{Affined{}, affine_from_dual_quat(motions[1])} {}

  std::span<const DualQuatd> rigid() const { return motions; }
  std::span<const Affined> affine() const { return matrices; }

  std::vector<DualQuatd> motions;
  std::vector<Affined> matrices;
};

const std::vector<double> kHalf{0.5, 0.5};
const std::span<const Mat3<double>> kNoStretch;

TEST(reference_skinning, twisted_skin_shrinks_linearly_and_keeps_its_radius_otherwise) {
  const Vec3<double> p(0.25, 1, 0), n(0, 1, 0), center(0.25, 0, 0);
  for (const double angle : {0.1, 1.0, 2.0, 3.1}) {
    const Twist twist(angle);
    const Vec3<double> half_turned(0.25, std::cos(angle / 2), std::sin(angle / 2));
    EXPECT_TRUE(is_near(skin_linear<double>(twist.affine(), kHalf, p),
                        Vec3<double>(0.25, (1 + std::cos(angle)) / 2, std::sin(angle) / 2), 1e-15));
    EXPECT_TRUE(
        is_near(skin_dual_quaternion<double>(twist.rigid(), kNoStretch, kHalf, p, n).position, half_turned, 1e-15));
    EXPECT_TRUE(is_near(skin_center_of_rotation<double>(twist.rigid(), twist.affine(), kHalf, p, n, center).position,
                        half_turned, 1e-15));
  }
}

TEST(reference_skinning, N17_sign_of_any_motion_does_not_matter) {
  test::FixedRandom random(1);
  std::vector<DualQuatd> motions;
  for (int i = 0; i < 4; ++i) motions.push_back(dual_quat_from(random.rotation_by<double>(1.0), random.vec3<double>()));
  const std::vector<double> weights{0.4, 0.3, 0.2, 0.1};
  const auto expected = blend_motions<double>(motions, weights).motion;
  for (auto& m : motions) {
    m = {-m.real, -m.dual};
    const auto found = blend_motions<double>(motions, weights).motion;
    EXPECT_TRUE(is_near(affine_from_dual_quat(found), affine_from_dual_quat(expected), 1e-14));
  }
}

TEST(reference_skinning, N18_pivot_is_the_heaviest_and_the_first_of_equals) {
  EXPECT_EQ(reference::pivot_of<double>(std::vector<double>{0.2, 0.4, 0.4}), 1u);
  EXPECT_EQ(reference::pivot_of<double>(std::vector<double>{0.5, 0.5}), 0u);
}

TEST(reference_skinning, N17_aligned_blend_never_cancels_and_without_weight_it_follows_its_pivot) {
  // Every aligned motion has sum . pivot >= w_pivot > 0, so positive weights keep at least the pivot's share of the
  // length.
  test::FixedRandom random(3);
  std::vector<DualQuatd> motions(4);
  const std::vector<double> quarter(4, 0.25);
  for (int i = 0; i < 1000; ++i) {
    for (auto& m : motions) m = dual_quat_from(random.rotation<double>(), random.vec3<double>());
    EXPECT_GE(blend_motions<double>(motions, quarter).length, 0.25);
  }
  const std::vector<double> nothing{1.0, -1.0, 0.0, 0.0};
  motions[1] = motions[0];
  EXPECT_TRUE(is_near(affine_from_dual_quat(blend_motions<double>(motions, nothing).motion),
                      affine_from_dual_quat(motions[0]), 1e-14));
}

TEST(reference_skinning, weights_of_any_sum_are_renormalised) {
  const Twist twist(1.2);
  const Vec3<double> p(0.1, 0.7, 0.4), n(0, 1, 0), center(0, 0.1, 0);
  const std::vector<double> small{0.003, 0.001}, unit{0.75, 0.25};
  EXPECT_TRUE(
      is_near(skin_linear<double>(twist.affine(), small, p), skin_linear<double>(twist.affine(), unit, p), 1e-15));
  EXPECT_TRUE(is_near(skin_dual_quaternion<double>(twist.rigid(), kNoStretch, small, p, n).position,
                      skin_dual_quaternion<double>(twist.rigid(), kNoStretch, unit, p, n).position, 1e-15));
  EXPECT_TRUE(is_near(skin_center_of_rotation<double>(twist.rigid(), twist.affine(), small, p, n, center).position,
                      skin_center_of_rotation<double>(twist.rigid(), twist.affine(), unit, p, n, center).position,
                      1e-15));
}

TEST(reference_skinning, N19_two_phases_of_one_joint_are_its_matrix) {
  test::FixedRandom random(2);
  const auto local = random.transform<double>();
  Mat3<double> stretch(1.0);
  for (int i = 0; i < 3; ++i) stretch[i][i] = local.scale[i];
  const std::vector<DualQuatd> motion{dual_quat_from(local.rotation, local.translation)};
  const std::vector<Mat3<double>> stretches{stretch};
  const std::vector<double> one{1.0};
  const auto p = random.vec3<double>(), n = random.direction<double>();
  const auto m = affine_from_transform(local);
  const auto skinned = skin_dual_quaternion<double>(motion, stretches, one, p, n);
  EXPECT_TRUE(is_near(skinned.position, transform_point(m, p), 1e-14));
  EXPECT_TRUE(is_near(skinned.normal, transform_normal_outward(linear_part(m), n), 1e-14));
}

TEST(reference_skinning, half_turns_both_ways_are_accepted_at_180_degrees) {
  const Twist twist(kPi);
  const auto p =
      skin_dual_quaternion<double>(twist.rigid(), kNoStretch, kHalf, Vec3<double>(0, 1, 0), Vec3<double>(0, 1, 0));
  EXPECT_NEAR(std::abs(p.position.z), 1, 1e-15);
}

/// Angles of a sweep through 720 degrees, in degrees, at which a vertex between the two bones jumped.
template <class Skin>
std::vector<double> jumps_of(Skin skin) {
  constexpr double kStep = kPi / 360;  // half a degree: a vertex 1 m from the axis may move 9 mm
  std::vector<double> jumps;
  Vec3<double> last = skin(Twist(0));
  for (int i = 1; i <= 1440; ++i) {
    const Vec3<double> now = skin(Twist(i * kStep));
    if (test::distance(now, last) > 1.5 * kStep) jumps.push_back(i * 0.5);
    last = now;
  }
  return jumps;
}

TEST(reference_skinning, N17_skin_moves_continuously_through_720_degrees_but_for_the_half_turns) {
  const Vec3<double> p(0.25, 1, 0), n(0, 1, 0), center(0.25, 0, 0);
  const std::vector<double> uneven{0.7, 0.3};
  for (const auto& weights : {kHalf, uneven}) {
    EXPECT_TRUE(jumps_of([&](const Twist& t) { return skin_linear<double>(t.affine(), weights, p); }).empty());
    const auto dual = jumps_of(
        [&](const Twist& t) { return skin_dual_quaternion<double>(t.rigid(), kNoStretch, weights, p, n).position; });
    const auto about_center = jumps_of([&](const Twist& t) {
      return skin_center_of_rotation<double>(t.rigid(), t.affine(), weights, p, n, center).position;
    });
    // The documented exception: past a half turn between the bones, the shorter way round is the other one.
    ASSERT_EQ(dual.size(), 2u);
    EXPECT_NEAR(dual[0], 180, 0.5);
    EXPECT_NEAR(dual[1], 540, 0.5);
    EXPECT_EQ(about_center, dual);
  }
}

}  // namespace
}  // namespace sinew
