// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "runtime/retarget/hold_feet.h"
#include "tests/scenes/two_legs.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/near.h"
#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

using namespace scenes;

/// The job on a pose and its retargeted one gives what hold_feet does in double.
void expect_job_is_the_truth(const FeetMap& feet, const Skeleton& target, float ground,
                             const std::vector<Transformd>& pose, const std::vector<Transformd>& retargeted) {
  test::PoseBuffer source(pose.size()), held(retargeted.size());
  const auto in_float = [](const Transformd& t) {
    return Transform{glm::vec3(t.translation), quat_cast<float>(t.rotation), glm::vec3(t.scale)};
  };
  for (std::size_t j = 0; j < pose.size(); ++j) source.span().set(j, in_float(pose[j]));
  for (std::size_t j = 0; j < retargeted.size(); ++j) held.span().set(j, in_float(retargeted[j]));
  std::vector<Transformd> truth = retargeted, found;
  hold_feet(feet, ground, pose, truth);
  const HoldFeetJob job{&feet, ground, source.span(), held.span()};
  ASSERT_EQ(check(job), ErrorCode::ok);
  const test::AllocationCounter counter;
  EXPECT_EQ(run(job), ErrorCode::ok);
  EXPECT_EQ(counter.count(), 0u);
  for (std::size_t j = 0; j < truth.size(); ++j) found.push_back(in_double(held.span().get(j)));
  std::vector<Affined> exact_model(truth.size()), model(truth.size());
  model_from_local(target, truth, exact_model);
  model_from_local(target, found, model);
  for (std::size_t j = 0; j < truth.size(); ++j)
    EXPECT_TRUE(test::is_near(translation_of(model[j]), translation_of(exact_model[j]), 2e-6)) << j;
}

TEST(hold_feet_job, is_the_truth_within_rounding_and_allocates_nothing) {
  const Bodies b;
  for (int i = 0; i < 40; ++i) {
    const LiftedFoot foot(b, 0.1 - 0.005 * i);
    expect_job_is_the_truth(b.feet, b.target, 0.01f, foot.pose, foot.held);
  }
}

TEST(hold_feet_job, joints_with_a_fixed_matrix_are_at_rest_whatever_the_pose_holds) {
  const Bodies b;
  Skeleton target = b.target;
  target.fixed_matrices.emplace_back();
  target.fixed_matrix_of[hips] = 0;
  const FeetMap feet = make_feet_map(b.map, b.source, target);
  const LiftedFoot foot(b, 0.02);
  const auto rotations_with_hips_at = [&](const glm::vec3& place) {
    test::PoseBuffer source(foot.pose.size()), held(foot.held.size());
    const auto in_float = [](const Transformd& t) {
      return Transform{glm::vec3(t.translation), quat_cast<float>(t.rotation), glm::vec3(t.scale)};
    };
    for (std::size_t j = 0; j < foot.pose.size(); ++j) source.span().set(j, in_float(foot.pose[j]));
    for (std::size_t j = 0; j < foot.held.size(); ++j) held.span().set(j, in_float(foot.held[j]));
    Transform moved = held.span().get(hips);
    moved.translation = place;
    held.span().set(hips, moved);
    EXPECT_EQ(run(HoldFeetJob{&feet, 0.01f, source.span(), held.span()}), ErrorCode::ok);
    std::vector<glm::quat> rotations;
    for (std::size_t j = 0; j < foot.held.size(); ++j) rotations.push_back(held.span().get(j).rotation);
    return rotations;
  };
  EXPECT_EQ(rotations_with_hips_at(glm::vec3(0.0f)), rotations_with_hips_at(glm::vec3(3.0f, 4.0f, 5.0f)));
}

TEST(hold_feet_job, more_legs_than_a_body_has_are_held_alike) {
  const Bodies b;
  FeetMap more = b.feet;
  const LegPair left = b.feet.legs[0], right = b.feet.legs[1];
  more.legs = {right, right, right, right, left};
  for (int i = 0; i < 40; ++i) {
    const LiftedFoot foot(b, 0.1 - 0.005 * i);
    std::vector<Transformd> two = foot.held, five = foot.held;
    hold_feet(b.feet, 0.01, foot.pose, two);
    hold_feet(more, 0.01, foot.pose, five);
    for (std::size_t j = 0; j < two.size(); ++j) {
      EXPECT_EQ(two[j].rotation, five[j].rotation) << j;
      EXPECT_EQ(two[j].translation, five[j].translation) << j;
    }
  }
}

TEST(hold_feet_job, moves_hips_along_any_axis_of_their_parent) {
  const Bodies b;
  Skeleton below = below_a_root(b.target);
  const glm::quat turn = quat_cast<float>(test::FixedRandom(5).rotation<double>());
  below.rest[1].translation = rotate_vector(quat_conjugate(turn) * below.rest[0].rotation, below.rest[1].translation);
  below.rest[1].rotation = quat_conjugate(turn) * below.rest[0].rotation * below.rest[1].rotation;
  below.rest[0].rotation = turn;
  std::vector<std::array<std::uint32_t, 2>> pairs;
  for (std::uint32_t j = 0; j < 9; ++j) pairs.push_back({j, j + 1});
  const SkeletonMap map = make_skeleton_map(b.source, below, {.pairs = pairs});
  const FeetMap feet = make_feet_map(map, b.source, below);
  Animation animation;
  add_key(b.source, 0.0, Vec3d(0, -0.04, 0.05), {0.5, 0.1, 0.0}, animation);
  TruthPose pose;
  evaluate_truth(animation, b.source, 0.0, pose);
  std::vector<Transformd> retargeted(below.joint_count());
  retarget_pose(map, b.source, below, pose.local, retargeted);
  const auto ground = static_cast<float>(translation_of(pose.model[left_foot]).y - 0.1);
  expect_job_is_the_truth(feet, below, ground, pose.local, retargeted);
  std::vector<Transformd> held = retargeted;
  hold_feet(feet, ground, pose.local, held);
  for (int c = 0; c < 3; ++c)
    EXPECT_GT(std::abs(held[1].translation[c] - retargeted[1].translation[c]), 0.01) << "the case is one: axis " << c;
}

TEST(hold_feet_job, refuses_poses_without_the_joints) {
  Bodies b;
  test::PoseBuffer pose(b.source.joint_count()), few(3);
  EXPECT_EQ(check(HoldFeetJob{nullptr, 0, pose.span(), pose.span()}), ErrorCode::size_mismatch);
  EXPECT_EQ(check(HoldFeetJob{&b.feet, 0, few.span(), pose.span()}), ErrorCode::size_mismatch);
  EXPECT_EQ(check(HoldFeetJob{&b.feet, 0, pose.span(), few.span()}), ErrorCode::size_mismatch);
  std::uint32_t last = 0;
  for (const LegPair& leg : b.feet.legs)
    for (const LegJoint& joint : leg.target.joints) last = std::max(last, joint.joint);
  test::PoseBuffer without(last), with(last + 1);
  EXPECT_EQ(check(HoldFeetJob{&b.feet, 0, pose.span(), without.span()}), ErrorCode::size_mismatch) << "all but one";
  EXPECT_EQ(check(HoldFeetJob{&b.feet, 0, pose.span(), with.span()}), ErrorCode::ok);
}

}  // namespace
}  // namespace sinew
