// SPDX-License-Identifier: MIT
/// Clips that are larger than those of a character: a crowd in one file, or a recorded performance.
#include <gtest/gtest.h>

#include <cmath>

#include "runtime/pose/local_to_model.h"
#include "runtime/pose/sample_clip.h"
#include "tests/scenes/skeletons.h"
#include "tests/scenes/swinging.h"
#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

double angle_rad(const glm::quat& a, const Quat<double>& b) {
  const Quat<double> q = quat_cast<double>(a), d = q - (quat_dot(q, b) < 0 ? -b : b);
  return 2.0 * std::sqrt(quat_dot(d, d));
}

TEST(large_clips, ten_thousand_joints_are_sampled_and_composed) {
  constexpr std::uint32_t kJoints = 10'000;
  const Skeleton skeleton = scenes::wide_tree(kJoints, 3);
  const Animation animation = scenes::swinging(skeleton, 6);
  const Clip clip = test::clip_of(animation, skeleton);
  EXPECT_EQ(clip.counts().rotations, kJoints);
  test::PoseBuffer pose(kJoints);
  std::vector<Affine> model(kJoints);
  const double time_s = 0.0717;
  const SampleClipJob sample{.clip = &clip, .time_s = time_s, .pose = pose.span(), .weights = {}};
  const LocalToModelJob compose{&skeleton, pose.span(), {}, model};
  ASSERT_EQ(run(sample), ErrorCode::ok);
  ASSERT_EQ(run(compose), ErrorCode::ok);
  std::vector<Affined> truth(kJoints);
  for (std::uint32_t j = 0; j < kJoints; ++j) {
    const Transform& rest = skeleton.rest[j];
    const Transformd at_rest{Vec3<double>(rest.translation), quat_cast<double>(rest.rotation),
                             Vec3<double>(rest.scale)};
    const Transformd local = animation.bones[j].interpolate<double>(time_s, at_rest);
    ASSERT_LT(angle_rad(pose.span().get(j).rotation, local.rotation), 4e-7) << j;
    truth[j] = affine_from_transform(local);
    if (skeleton.parents[j] != kNone) truth[j] = truth[skeleton.parents[j]] * truth[j];
    for (int r = 0; r < 3; ++r) ASSERT_NEAR(static_cast<double>(model[j].row[r].w), truth[j].row[r].w, 1e-5) << j;
  }
}

TEST(large_clips, an_hour_of_keys_is_as_exact_at_its_end_as_at_its_begin) {
  constexpr std::size_t kKeys = 30 * 3600 + 1;
  const Skeleton skeleton = scenes::long_chain(2);
  const Animation animation = scenes::swinging(skeleton, kKeys);
  const Clip clip = test::clip_of(animation, skeleton);
  EXPECT_NEAR(clip.duration_s(), 3600.0, 1e-9);
  test::PoseBuffer pose(2);
  test::FixedRandom random(36);
  for (int i = 0; i < 2000; ++i) {
    const double time_s = i == 0 ? clip.duration_s() : i % 2 ? random.in(3500, 3600) : random.in(0, 3600);
    EXPECT_EQ(run(SampleClipJob{.clip = &clip, .time_s = time_s, .pose = pose.span(), .weights = {}}), ErrorCode::ok);
    for (std::uint32_t j = 0; j < 2; ++j)
      ASSERT_LT(angle_rad(pose.span().get(j).rotation, animation.bones[j].interpolate<double>(time_s).rotation), 4e-7)
          << time_s;
  }
}

}  // namespace
}  // namespace sinew
