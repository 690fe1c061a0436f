// SPDX-License-Identifier: MIT
#include "runtime/clip/rebind_clip.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "runtime/base/same_bits.h"
#include "runtime/clip/clip_layout.h"
#include "runtime/clip/unpack_clip.h"
#include "runtime/math/quaternion.h"
#include "tests/clip/varied_clip.h"

namespace sinew::test {
namespace {

struct Sample {
  std::vector<Transform> pose;
  std::vector<float> weights, numbers;
};

Sample sample(const Clip& clip, double time_s) {
  PoseBuffer pose(clip.joint_count());
  Sample out{{}, std::vector<float>(clip.weight_count()), std::vector<float>(clip.property_count())};
  const SampleClipJob job{
      .clip = &clip, .time_s = time_s, .pose = pose.span(), .weights = out.weights, .properties = out.numbers};
  EXPECT_EQ(check(job), ErrorCode::ok);
  EXPECT_EQ(run(job), ErrorCode::ok);
  for (std::size_t j = 0; j < clip.joint_count(); ++j) out.pose.push_back(pose.span().get(j));
  return out;
}

/// Rest values under which the clip has few constants.
ClipRest rest_under(const Clip& clip) {
  const ClipLayout& layout = clip.layout();
  return {clip.joint_count(), layout.base_pose.rest(), layout.base_weights.rest(), layout.base_properties.rest()};
}

ClipTargets each_to_itself(const Clip& clip) {
  ClipTargets targets;
  for (std::uint32_t i = 0; i < clip.joint_count(); ++i) targets.joints.push_back(i);
  for (std::uint32_t i = 0; i < clip.weight_count(); ++i) targets.weights.push_back(i);
  for (std::uint32_t i = 0; i < clip.property_count(); ++i) targets.numbers.push_back(i);
  return targets;
}

ClipRest random_rest(std::uint32_t joints, std::size_t weights, FixedRandom& random) {
  Skeleton skeleton = chain_skeleton(joints);
  for (Transform& rest : skeleton.rest) rest = random.transform();
  std::vector<float> at_rest(weights);
  for (float& weight : at_rest) weight = static_cast<float>(random.in(0, 1));
  return clip_rest(skeleton, at_rest, {});
}

Transform at_rest(const ClipRest& rest, std::uint32_t joint) {
  const std::size_t stride = BasePose::stride_for(rest.joint_count);
  const auto number = [&](std::size_t plane) { return (*rest.pose)[plane * stride + joint]; };
  return {{number(0), number(1), number(2)},
          quat_xyzw(number(3), number(4), number(5), number(6)),
          {number(7), number(8), number(9)}};
}

const TrackBlock& block_with_lanes(const Clip& clip) {
  for (const TimeGroup& group : clip.layout().groups)
    for (const TrackBlock& block : group.blocks)
      if (!block.rows.empty()) return block;
  throw std::logic_error("no block has rows");
}

TEST(rebind_clip, where_nothing_differs_it_is_the_same_handle) {
  const Clip clip = varied_clip(1);
  const ClipRest from = rest_under(clip);
  ClipRest equal = from;
  equal.pose = rest_numbers(*from.pose);  // equal bits in other memory
  EXPECT_EQ(&rebind_clip(clip, from, each_to_itself(clip), equal).layout(), &clip.layout());
}

TEST(rebind_clip, joints_in_another_order_keep_the_bits_of_their_tracks) {
  for (std::uint64_t seed = 1; seed < 17; ++seed) {
    const Clip clip = seed % 2 == 0 ? unpacked(varied_clip(seed)) : varied_clip(seed);
    const ClipRest from = rest_under(clip);
    const ClipMotion motion = motion_of(clip, from);
    FixedRandom random(seed);
    ClipTargets targets = each_to_itself(clip);
    for (std::uint32_t j = 0; j < targets.joints.size(); ++j)
      std::swap(targets.joints[j], targets.joints[random.below(static_cast<std::uint32_t>(j + 1))]);
    for (std::uint32_t& joint : targets.joints) joint += 5;
    targets.joints[3] = kNone;
    targets.weights = {2, 7, kNone, 0};  // neighbours of the clip are no neighbours here
    const ClipRest to = random_rest(30, 9, random);
    const Clip bound = rebind_clip(clip, from, targets, to);
    for (double t = -0.5; t < 5; t += 0.083) {
      const Sample before = sample(clip, t), after = sample(bound, t);
      std::vector<bool> is_target(to.joint_count);
      for (std::uint32_t j = 0; j < targets.joints.size(); ++j) {
        if (!motion.joints[j] || targets.joints[j] == kNone) continue;
        is_target[targets.joints[j]] = true;
        const Transform rest = at_rest(to, targets.joints[j]), old_rest = at_rest(from, j), x = before.pose[j];
        const Transform expected{same_bits(x.translation, old_rest.translation) ? rest.translation : x.translation,
                                 same_bits(x.rotation, old_rest.rotation) ? rest.rotation : x.rotation,
                                 same_bits(x.scale, old_rest.scale) ? rest.scale : x.scale};
        EXPECT_TRUE(same_bits(after.pose[targets.joints[j]], expected)) << "joint " << j << " at " << t;
      }
      for (std::uint32_t j = 0; j < to.joint_count; ++j)
        EXPECT_TRUE(is_target[j] || same_bits(after.pose[j], at_rest(to, j))) << j;
      for (std::size_t w = 0; w < 9; ++w) {
        const std::size_t source = w == 2 ? 0 : w == 7 ? 1 : 3;
        const bool moved = (w == 2 || w == 7 || w == 0) && motion.weights[source];
        EXPECT_TRUE(same_bits(after.weights[w], moved ? before.weights[source] : (*to.weights)[w])) << w;
      }
    }
  }
}

TEST(rebind_clip, another_rest_pose_shares_all_keys_and_moves_what_the_clip_does_not) {
  const Clip clip = varied_clip(2);
  const ClipRest from = rest_under(clip);
  FixedRandom random(5);
  const ClipRest to = random_rest(static_cast<std::uint32_t>(clip.joint_count()), clip.weight_count(), random);
  const Clip bound = rebind_clip(clip, from, each_to_itself(clip), to);
  EXPECT_TRUE(block_with_lanes(bound).rows.shares_with(block_with_lanes(clip).rows));
  EXPECT_EQ(bound.counts().rotations, clip.counts().rotations);
  EXPECT_EQ(bound.counts().time_groups, clip.counts().time_groups);
  const std::vector<bool> moved = motion_of(clip, from).joints;
  const auto still = static_cast<std::uint32_t>(std::find(moved.begin(), moved.end(), false) - moved.begin());
  ASSERT_LT(still, moved.size());
  EXPECT_TRUE(same_bits(sample(bound, 1.0).pose[still], at_rest(to, still)));
}

/// A clip in which joint 0 has the constant translation `held`, and joint 1 turns.
Clip holding_clip(const Skeleton& skeleton, const glm::vec3& held) {
  BoneAnimation hold, turn;
  hold.joint = 0;
  hold.translation = track_of<glm::vec3>(Interpolation::linear, {0, 1}, {held, held});
  turn.joint = 1;
  turn.rotation = track_of<glm::quat>(Interpolation::linear, {0, 1}, {glm::quat(1, 0, 0, 0), glm::quat(0, 1, 0, 0)});
  return clip_of(animation_of({hold, turn}), skeleton);
}

TEST(rebind_clip, a_constant_is_motion_only_where_it_differs_from_the_rest_of_its_own_file) {
  Skeleton skeleton = chain_skeleton(2), other = skeleton;
  skeleton.rest[0].translation = {1, 2, 3};
  other.rest[0].translation = {4, 5, 6};
  const ClipRest from = clip_rest(skeleton, {}, {}), to = clip_rest(other, {}, {});
  const Clip at_rest = holding_clip(skeleton, {1, 2, 3}), elsewhere = holding_clip(skeleton, {1, 2, 4});
  EXPECT_EQ(motion_of(at_rest, from).joints, (std::vector<bool>{false, true}));
  EXPECT_EQ(motion_of(elsewhere, from).joints, (std::vector<bool>{true, true}));

  const ClipTargets targets = each_to_itself(at_rest);
  EXPECT_EQ(sample(rebind_clip(at_rest, from, targets, to), 0.5).pose[0].translation, glm::vec3(4, 5, 6));
  const Clip bound = rebind_clip(elsewhere, from, targets, to);
  EXPECT_EQ(sample(bound, 0.5).pose[0].translation,
            glm::vec3(1, 2, 4));  // all components, also those equal to the rest value
  EXPECT_EQ(bound.counts().folded, 1u);
}

TEST(rebind_clip, times_of_tracks_that_go_nowhere_are_gone) {
  FixedRandom random(3);
  Animation animation;
  for (const std::uint32_t j : {0u, 1u})
    animation.bones.push_back(
        {.joint = j, .rotation = random_rotations(random, Interpolation::linear, random_times(random, 4))});
  const Clip clip = clip_of(animation, chain_skeleton(2));
  ASSERT_EQ(clip.layout().groups.size(), 2u);
  const Clip bound = rebind_clip(clip, rest_under(clip), {{kNone, 0}, {}, {}}, random_rest(1, 0, random));
  EXPECT_EQ(bound.layout().groups.size(), 1u);
  EXPECT_EQ(bound.counts().time_groups, 1u);
  EXPECT_EQ(bound.counts().rotations, 1u);
}

TEST(rebind_clip, a_certificate_stays_with_the_skeleton_that_it_was_measured_on) {
  const Clip clip = varied_clip(4);
  const ClipRest from = rest_under(clip);
  ClipTargets targets = each_to_itself(clip);
  targets.weights = {3, 2, 1, 0};
  EXPECT_TRUE(rebind_clip(clip, from, targets, from).certificate().has_value());
  std::swap(targets.joints[0], targets.joints[1]);
  EXPECT_FALSE(rebind_clip(clip, from, targets, from).certificate().has_value());
}

}  // namespace
}  // namespace sinew::test
