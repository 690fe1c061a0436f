// SPDX-License-Identifier: MIT
#include "runtime/retarget/retarget_pose.h"

#include <gtest/gtest.h>

#include <cstring>

#include "runtime/animation/truth_pose.h"
#include "runtime/retarget/retarget_animation.h"
#include "tests/scenes/two_sided.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/near.h"
#include "tests/support/simd_targets.h"
#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

using scenes::RightSide;

struct Retargeted {
  Skeleton from, to;
  SkeletonMap map;
  RetargetTables tables;
  std::vector<Transform> local;
  test::PoseBuffer pose{14}, scratch{14}, out{14};

  Retargeted(Skeleton source, Skeleton target, std::uint64_t seed)
      : from(std::move(source)),
        to(std::move(target)),
        map(make_skeleton_map(from, to)),
        tables(make_retarget_tables(map, from, to)),
        local(scenes::moved_from_rest(from, seed)) {
    for (std::size_t j = 0; j < local.size(); ++j) pose.span().set(j, local[j]);
  }
  RetargetPoseJob job() { return {&tables, pose.span(), scratch.span(), out.span()}; }
};

/// Bodies with other bone axes and lengths. In the second pair nothing follows the forearm above the hand.
Retargeted two_bodies(std::uint64_t seed, bool all_joints) {
  Skeleton to = scenes::two_sided(RightSide::another_posture, seed + 20).skeleton;
  if (!all_joints) to.names[9] = "something";
  return {scenes::two_sided(RightSide::any_axes, seed).skeleton, to, seed};
}

/// Joints of the target rest with different scales per axis, which scales of the source multiply.
Retargeted scaled_bodies() {
  Skeleton from = scenes::two_sided(RightSide::any_axes, 1).skeleton, to = from;
  for (std::size_t j = 0; j < to.rest.size(); ++j) to.rest[j].scale = {1.0f, 1.5f, 2.0f + 0.1f * static_cast<float>(j)};
  Retargeted r(from, to, 1);
  for (std::size_t j = 0; j < r.local.size(); ++j) {
    r.local[j].scale = {0.9f, 1.1f + 0.01f * static_cast<float>(j), 1.3f};
    r.pose.span().set(j, r.local[j]);
  }
  return r;
}

TEST(retarget_pose, scales_multiply_those_at_rest_axis_by_axis) {
  Retargeted r = scaled_bodies();
  EXPECT_EQ(run(r.job()), ErrorCode::ok);
  for (std::size_t j = 0; j < 14; ++j)
    EXPECT_TRUE(test::is_near(r.out.span().get(j).scale, r.to.rest[j].scale * r.local[j].scale, 1e-6)) << j;
}

TEST(retarget_pose, rejects_other_joint_counts_and_a_missing_scratch) {
  Retargeted r = two_bodies(1, false);
  test::PoseBuffer other(60);
  EXPECT_EQ(check(r.job()), ErrorCode::ok);
  RetargetPoseJob job = r.job();
  job.tables = nullptr;
  EXPECT_EQ(check(job), ErrorCode::size_mismatch);
  job = r.job();
  job.retargeted = other.span();
  EXPECT_EQ(check(job), ErrorCode::size_mismatch);
  job = r.job();
  job.scratch = {};
  EXPECT_EQ(check(job), ErrorCode::size_mismatch);
  Retargeted plain = two_bodies(1, true);
  job = plain.job();
  job.scratch = {};
  EXPECT_EQ(check(job), ErrorCode::ok) << "nothing is composed";
}

TEST(retarget_pose, agrees_with_double_and_every_instruction_set_gives_the_same_bits) {
  for (const bool all_joints : {true, false})
    for (std::uint64_t seed = 1; seed < 5; ++seed) {
      std::vector<Transform> first;
      for (const std::int64_t target : test::simd_targets()) {
        const test::OnlyTarget only(target);
        Retargeted r = two_bodies(seed, all_joints);
        std::vector<Transformd> exact, truth(14);
        for (const Transform& t : r.local) exact.push_back(in_double(t));
        retarget_pose(r.map, r.from, r.to, exact, truth);
        const test::AllocationCounter counter;
        EXPECT_EQ(run(r.job()), ErrorCode::ok);
        EXPECT_EQ(counter.count(), 0u);
        std::vector<Transform> found;
        for (std::size_t j = 0; j < 14; ++j) {
          found.push_back(r.out.span().get(j));
          EXPECT_TRUE(test::is_near(Vec3<double>(found[j].translation), truth[j].translation, 1e-6)) << j;
          EXPECT_LT(test::angle_between(found[j].rotation, truth[j].rotation), 1e-6) << j;
          EXPECT_TRUE(test::is_near(Vec3<double>(found[j].scale), truth[j].scale, 1e-6)) << j;
        }
        if (first.empty()) first = found;
        EXPECT_TRUE(found == first) << test::simd_name(target);
      }
    }
}

TEST(retarget_pose, joints_of_the_source_with_a_fixed_matrix_rest_whatever_the_pose_has_there) {
  for (const std::uint32_t fixed : {1u, 9u}) {
    Skeleton from = scenes::two_sided(RightSide::any_axes, 1).skeleton;
    from.fixed_matrix_of[fixed] = 0;
    from.fixed_matrices = {affine_from_transform(from.rest[fixed])};
    Retargeted r(from, scenes::two_sided(RightSide::another_posture, 2).skeleton, 3);
    std::vector<Transformd> exact, truth(14);
    for (const Transform& t : r.local) exact.push_back(in_double(t));
    exact[fixed] = in_double(from.rest[fixed]);
    Skeleton free = r.from;
    free.fixed_matrix_of[fixed] = kNone;
    retarget_pose(r.map, free, r.to, exact, truth);
    EXPECT_EQ(run(r.job()), ErrorCode::ok);
    for (std::size_t j = 0; j < 14; ++j) {
      EXPECT_TRUE(test::is_near(Vec3<double>(r.out.span().get(j).translation), truth[j].translation, 1e-6)) << j;
      EXPECT_LT(test::angle_between(r.out.span().get(j).rotation, truth[j].rotation), 1e-6) << j;
    }
  }
}

TEST(retarget_pose, scales_of_joints_with_a_fixed_matrix_rest_whatever_the_pose_has) {
  Skeleton from = scenes::two_sided(RightSide::any_axes, 1).skeleton, to = from;
  from.rest[9].scale = {2, 2, 2};
  from.fixed_matrix_of[9] = 0;
  from.fixed_matrices = {affine_from_transform(from.rest[9])};
  to.rest[9].scale = {1, 3, 5};
  Retargeted r(from, to, 3);
  ASSERT_TRUE(r.map.by_names);
  std::vector<Transformd> pose, truth(14);
  for (const Transform& t : r.local) pose.push_back(in_double(t));
  retarget_pose(r.map, r.from, r.to, pose, truth);
  EXPECT_TRUE(test::is_near(truth[9].scale, Vec3<double>(1, 3, 5), 1e-6));
  ASSERT_EQ(run(r.job()), ErrorCode::ok);
  EXPECT_TRUE(test::is_near(r.out.span().get(9).scale, glm::vec3(1, 3, 5), 2e-6));
}

/// A second forearm of the target follows the same source forearm. A second hand follows the same source hand, but
/// below a forearm that rests.
TEST(retarget_pose, a_joint_of_the_source_is_seen_from_different_joints_above_at_once) {
  const Skeleton from = scenes::two_sided(RightSide::any_axes).skeleton;
  SkeletonMapOptions options;
  for (std::uint32_t j = 0; j < 14; ++j)
    if (j != 6 && j != 8 && j != 10 && j != 12) options.pairs.push_back({j, j});
  options.pairs.insert(options.pairs.end(), {{5, 6}, {11, 12}});
  for (std::uint64_t seed = 1; seed < 4; ++seed) {
    Retargeted r(from, scenes::two_sided(RightSide::another_posture, seed).skeleton, seed);
    r.map = make_skeleton_map(r.from, r.to, options);
    ASSERT_EQ(r.map.joints.size(), options.pairs.size());
    r.tables = make_retarget_tables(r.map, r.from, r.to);
    std::vector<Transformd> exact, truth(14);
    for (const Transform& t : r.local) exact.push_back(in_double(t));
    retarget_pose(r.map, r.from, r.to, exact, truth);
    ASSERT_EQ(run(r.job()), ErrorCode::ok);
    for (std::size_t j = 0; j < 14; ++j) {
      const Transform found = r.out.span().get(j);
      EXPECT_TRUE(test::is_near(Vec3<double>(found.translation), truth[j].translation, 1e-6)) << j;
      EXPECT_LT(test::angle_between(found.rotation, truth[j].rotation), 1e-6) << j;
    }
  }
}

TEST(retarget_pose, on_its_own_skeleton_a_pose_keeps_its_bits) {
  const Skeleton skeleton = scenes::two_sided(RightSide::any_axes).skeleton;
  Retargeted r(skeleton, skeleton, 3);
  EXPECT_EQ(run(r.job()), ErrorCode::ok);
  for (std::size_t j = 0; j < 14; ++j) {
    const Transform same = r.out.span().get(j);
    EXPECT_EQ(0, std::memcmp(&same, &r.local[j], sizeof same)) << j;
  }
}

}  // namespace
}  // namespace sinew
