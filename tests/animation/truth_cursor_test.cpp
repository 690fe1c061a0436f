// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>

#include "runtime/animation/truth_pose.h"
#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

constexpr Interpolation kKinds[] = {Interpolation::step, Interpolation::linear, Interpolation::cubic_spline,
                                    Interpolation::squad};

/// Tracks of every kind, with jumps, and two of them for each joint.
Animation random_animation(test::FixedRandom& random, std::uint32_t joints) {
  std::vector<BoneAnimation> bones;
  for (std::uint32_t b = 0; b < 2 * joints; ++b) {
    BoneAnimation& bone = bones.emplace_back();
    bone.joint = b % joints;
    const auto times = [&] { return test::random_times(random, 3 + random.below(9), random.below(3)); };
    const Interpolation kind = kKinds[random.below(4)], of_vectors = kKinds[random.below(3)];
    if (random.below(3) != 0) bone.translation = test::random_vectors(random, of_vectors, times());
    if (random.below(3) != 0) bone.rotation = test::random_rotations(random, kind, times());
    if (random.below(3) != 0) bone.scale = test::random_vectors(random, of_vectors, times());
  }
  return test::animation_of(std::move(bones));
}

TEST(truth_cursor, gives_the_bits_of_evaluate_truth_in_any_order_of_times) {
  test::FixedRandom random(3);
  const Skeleton skeleton = test::chain_skeleton(5);
  for (int round = 0; round < 60; ++round) {
    const Animation animation = random_animation(random, 5);
    TruthCursor cursor(animation, skeleton);
    std::vector<double> times_s;
    for (const BoneAnimation& bone : animation.bones)
      times_s.insert(times_s.end(), bone.rotation.times_s.begin(), bone.rotation.times_s.end());
    for (int i = 0; i < 60; ++i) times_s.push_back(random.in(-0.5, animation.duration_s + 0.5));
    const std::size_t jumping = times_s.size();
    times_s.insert(times_s.end(), times_s.begin(), times_s.begin() + static_cast<std::ptrdiff_t>(jumping));
    std::sort(times_s.begin() + static_cast<std::ptrdiff_t>(jumping), times_s.end());
    TruthPose pose, truth;
    for (const double time_s : times_s) {
      cursor.evaluate(time_s, pose);
      evaluate_truth(animation, skeleton, time_s, truth);
      ASSERT_EQ(pose.local, truth.local) << time_s;
      ASSERT_EQ(pose.model, truth.model) << time_s;
    }
  }
}

}  // namespace
}  // namespace sinew
