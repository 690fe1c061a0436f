// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cmath>
#include <cstdint>

#include "runtime/procedures/joint_frames.h"
#include "runtime/procedures/two_bone_ik.h"
#include "tests/scenes/two_legs.h"
#include "tests/support/tiny_assets.h"

namespace sinew::test {

/// A body of two legs that walks along +z of model space at 1 m/s, in place. Its feet go back 0.6 m while they stand,
/// for 0.6 of each second. Then they return in the air.
class Walker {
 public:
  static constexpr double kSpeed_m_s = 1.0;

  Walker() : skeleton(scenes::body({.thigh = 0.5, .shank = 0.45, .knee_back = -0.03}, 5)) {}

  Skeleton skeleton;

  /// The clip at one time.
  PoseBuffer pose(double time_s) const {
    PoseBuffer pose(skeleton.joint_count());
    for (std::size_t j = 0; j < skeleton.joint_count(); ++j) pose.span().set(j, skeleton.rest[j]);
    Transform hips = skeleton.rest[scenes::hips];
    hips.translation.y -= 0.12f;
    pose.span().set(scenes::hips, hips);
    for (std::uint32_t side = 0; side < 2; ++side) {
      const Affined rest = model_matrix(skeleton, rest_pose(), scenes::left_foot + side);
      double phase = time_s + (side == 0 ? 0.0 : 0.5);
      phase -= std::floor(phase);
      Vec3<double> place = translation_of(rest);
      if (phase < 0.6) {
        place.z += 0.3 - phase * kSpeed_m_s;
      } else {
        const double air = (phase - 0.6) / 0.4, ease = air * air * (3.0 - 2.0 * air);
        place.z += -0.3 + 0.6 * ease;
        place.y += 0.12 * std::sin(M_PI * air);
      }
      TwoBoneIkJob ik{.skeleton = &skeleton, .local = pose.span(), .goal = {}};
      ik.goal.root = scenes::left_thigh + side;
      ik.goal.middle = scenes::left_shank + side;
      ik.goal.tip = scenes::left_foot + side;
      ik.goal.target = place;
      ik.goal.end = EndRotation::given;
      ik.goal.end_rotation = quat_cast<float>(model_rotation(skeleton, rest_pose(), scenes::left_foot + side));
      run_unchecked(ik);
    }
    return pose;
  }

 private:
  PoseSpan rest_pose() const {
    for (std::size_t j = 0; j < skeleton.joint_count(); ++j) rest_.span().set(j, skeleton.rest[j]);
    return rest_.span();
  }
  mutable PoseBuffer rest_{9};
};

}  // namespace sinew::test
