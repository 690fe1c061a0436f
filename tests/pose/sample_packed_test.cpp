// SPDX-License-Identifier: MIT
// Clips whose keys are rounded: what the lanes make of packed rows.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "runtime/clip/clip_layout.h"
#include "runtime/pose/sample_clip.h"
#include "tests/reference/sampling.h"
#include "tests/support/near.h"
#include "tests/support/simd_targets.h"
#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

constexpr std::uint32_t kPackedJoints = 70;
constexpr double kTolerance = 1e-3;

struct Packed {
  Animation animation;
  Clip clip;
};

/// Every second joint turns and moves, in two time groups; steps of up to `step_rad` between keys.
Packed packed(double step_rad) {
  test::FixedRandom random(17);
  const std::vector<float> times[] = {test::random_times(random, 14), test::random_times(random, 9)};
  std::vector<BoneAnimation> bones;
  KeyTolerances rounding;
  for (std::uint32_t j = 0; j < kPackedJoints; j += 1 + random.below(3)) {
    BoneAnimation bone;
    bone.joint = j;
    bone.rotation = {j % 7 == 0 ? Interpolation::step : Interpolation::linear, times[j % 2], {}};
    Quat<double> q = random.rotation<double>();
    for (std::size_t k = 0; k < bone.rotation.times_s.size(); ++k) {
      bone.rotation.values.push_back(quat_cast<float>(random.below(2) ? q : -q));
      q = q * random.rotation_by<double>(random.in(0, step_rad));
    }
    bone.translation = test::random_vectors(random, Interpolation::linear, times[j % 2]);
    bones.push_back(bone);
    rounding.bones.push_back({kTolerance, kTolerance, 0.0});
  }
  Packed out{test::animation_of(std::move(bones)), {}};
  out.clip = compile_clip(out.animation, test::chain_skeleton(kPackedJoints), {}, {}, {}, rounding);
  return out;
}

TEST(sample_packed, G01_N01_poses_between_and_on_keys_are_as_near_as_the_keys) {
  for (const double step_rad : {1e-5, 0.1, 1.0, 3.0}) {
    const Packed p = packed(step_rad);
    for (const TimeGroup& group : p.clip.layout().groups)
      for (const TrackBlock& block : group.blocks) EXPECT_FALSE(block.packed.empty());
    test::FixedRandom random(18);
    test::PoseBuffer pose(kPackedJoints);
    for (int i = 0; i < 120; ++i) {
      const double t =
          i < 14 ? double(p.animation.bones[0].rotation.times_s[std::min<std::size_t>(static_cast<std::size_t>(i), 8)])
                 : random.in(-0.1, p.animation.duration_s + 0.1);
      EXPECT_EQ(run(SampleClipJob{.clip = &p.clip, .time_s = t, .pose = pose.span(), .weights = {}}), ErrorCode::ok);
      for (const BoneAnimation& bone : p.animation.bones) {
        const Transform found = pose.span().get(bone.joint);
        EXPECT_TRUE(test::is_near(Vec3<double>(found.translation),
                                  reference::vec3_of(reference::sample(bone.translation, t)), kTolerance * 1.01));
        // Errors of the keys are weighted as the keys: by (sin(t a) + sin((1 - t) a)) / sin(a), at most 1 / cos(a / 2)
        // half way, a being half the angle between the keys.
        EXPECT_TRUE(test::same_rotation(found.rotation,
                                        reference::quat_of(reference::unit(reference::sample(bone.rotation, t))),
                                        kTolerance * 1.01 / std::cos(step_rad / 4) + 1e-6))
            << step_rad << " at " << t;
      }
    }
  }
}

TEST(sample_packed, N27_N28_every_instruction_set_gives_the_same_bits) {
  const Packed p = packed(0.5);
  const auto results = [&] {
    std::vector<float> numbers;
    test::PoseBuffer pose(kPackedJoints);
    for (double t = -0.1; t < p.animation.duration_s; t += 0.031) {
      EXPECT_EQ(run(SampleClipJob{.clip = &p.clip, .time_s = t, .pose = pose.span(), .weights = {}}), ErrorCode::ok);
      for (std::size_t plane = 0; plane < PoseSpan::plane_count; ++plane)
        numbers.insert(numbers.end(), pose.span().plane(PoseSpan::Plane(plane)),
                       pose.span().plane(PoseSpan::Plane(plane)) + kPackedJoints);
    }
    return numbers;
  };
  const std::vector<float> expected = results();
  for (const std::int64_t target : test::simd_targets()) {
    const test::OnlyTarget only(target);
    const std::vector<float> found = results();
    ASSERT_EQ(found.size(), expected.size());
    EXPECT_EQ(std::memcmp(found.data(), expected.data(), found.size() * sizeof(float)), 0) << test::simd_name(target);
  }
}

TEST(sample_packed, packed_weights_are_within_their_tolerance) {
  test::FixedRandom random(19);
  Animation animation;
  animation.weights.push_back(
      {0, test::random_weights(random, Interpolation::linear, test::random_times(random, 30), 21), 0});
  const std::vector<float> rest(21, 0.0f);
  const std::vector<std::uint32_t> first{0, 21};
  const Clip clip =
      compile_clip(animation, test::chain_skeleton(1), rest, first, {}, {{}, {std::vector<double>(21, 1e-3)}});
  EXPECT_FALSE(clip.layout().groups[0].blocks[0].packed.empty());
  std::vector<float> found(21);
  std::vector<double> expected(21);
  test::PoseBuffer pose(1);
  for (int i = 0; i < 100; ++i) {
    const double t = random.in(0, 15);
    EXPECT_EQ(run(SampleClipJob{.clip = &clip, .time_s = t, .pose = pose.span(), .weights = found}), ErrorCode::ok);
    sample_track<double>(animation.weights[0].weights, t, expected);
    for (std::size_t w = 0; w < 21; ++w) EXPECT_NEAR(static_cast<double>(found[w]), expected[w], 1.001e-3);
  }
}

}  // namespace
}  // namespace sinew
