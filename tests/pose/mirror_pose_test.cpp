// SPDX-License-Identifier: MIT
#include "runtime/pose/mirror_pose.h"

#include <gtest/gtest.h>

#include <cstring>

#include "runtime/animation/mirror_animation.h"
#include "tests/reference/mirror.h"
#include "tests/scenes/two_sided.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/near.h"
#include "tests/support/simd_targets.h"
#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

using scenes::RightSide;
using scenes::TwoSided;

constexpr std::uint32_t kSword = 13;  // keeps its own motion

struct Mirrored {
  TwoSided body;
  MirrorTables tables;
  std::vector<Transform> local;
  test::PoseBuffer pose, out;

  explicit Mirrored(RightSide right, std::uint64_t seed = 1)
      : body(scenes::two_sided(right, seed)),
        local(scenes::moved_from_rest(body.skeleton, seed + 10)),
        pose(local.size()),
        out(local.size()) {
    MirrorOptions options;
    options.plane_normal = glm::vec3(1, 0, 0);
    tables = make_mirror_tables(make_mirror_map(body.skeleton, options).joints);
    for (std::size_t j = 0; j < local.size(); ++j) pose.span().set(j, local[j]);
  }
  MirrorPoseJob job() { return {&tables, pose.span(), out.span()}; }
  std::size_t sums() const { return tables.rotation.joints.size() + tables.translation.joints.size(); }
};

TEST(mirror_pose, rejects_other_joint_counts_and_its_own_input_as_output) {
  Mirrored m(RightSide::any_axes);
  test::PoseBuffer other(m.local.size() + 40);
  EXPECT_EQ(check(m.job()), ErrorCode::ok);
  MirrorPoseJob job = m.job();
  job.tables = nullptr;
  EXPECT_EQ(check(job), ErrorCode::size_mismatch);
  job = m.job();
  job.mirrored = other.span();
  EXPECT_EQ(check(job), ErrorCode::size_mismatch);
  job = m.job();
  job.mirrored = job.pose;
  EXPECT_EQ(check(job), ErrorCode::size_mismatch);
}

TEST(mirror_pose, agrees_with_its_definition_and_every_instruction_set_gives_the_same_bits) {
  for (const RightSide right : scenes::kRightSides)
    for (std::uint64_t seed = 1; seed < 5; ++seed) {
      std::vector<Transform> first;
      for (const std::int64_t target : test::simd_targets()) {
        const test::OnlyTarget only(target);
        Mirrored m(right, seed);
        EXPECT_EQ(run(m.job()), ErrorCode::ok);
        const std::vector<Transformd> truth =
            reference::mirrored_pose(m.body.skeleton, m.body.skeleton.rest, m.local, m.body.partner, {1, 0, 0});
        std::vector<Transform> found;
        for (std::uint32_t j = 0; j < m.local.size(); ++j) {
          found.push_back(m.out.span().get(j));
          if (j == kSword) continue;
          EXPECT_TRUE(test::is_near(Vec3<double>(found[j].translation), truth[j].translation, 6e-7)) << j;
          EXPECT_LT(test::angle_between(found[j].rotation, truth[j].rotation), 6e-7) << j;
          EXPECT_TRUE(test::is_near(Vec3<double>(found[j].scale), truth[j].scale, 6e-7)) << j;
        }
        EXPECT_EQ(found[kSword], m.local[kSword]);
        if (first.empty()) first = found;
        EXPECT_TRUE(found == first) << test::simd_name(target);
      }
    }
}

TEST(mirror_pose, twice_mirrored_is_the_same_bit_for_bit_where_the_sides_are_mirror_images) {
  for (const RightSide right : {RightSide::mirrored_axes, RightSide::opposite_axes}) {
    Mirrored m(right);
    EXPECT_EQ(m.sums(), 0u) << "every number is copied";
    test::PoseBuffer twice(m.local.size());
    EXPECT_EQ(run(m.job()), ErrorCode::ok);
    EXPECT_EQ(run(MirrorPoseJob{&m.tables, m.out.span(), twice.span()}), ErrorCode::ok);
    for (std::size_t j = 0; j < m.local.size(); ++j) {
      const Transform back = twice.span().get(j);
      EXPECT_EQ(0, std::memcmp(&back, &m.local[j], sizeof(Transform))) << j;
    }
  }
}

TEST(mirror_pose, twice_mirrored_differs_by_rounding_alone_elsewhere) {
  for (const RightSide right : {RightSide::any_axes, RightSide::another_posture}) {
    Mirrored m(right);
    EXPECT_GT(m.sums(), 0u);
    test::PoseBuffer twice(m.local.size());
    EXPECT_EQ(run(m.job()), ErrorCode::ok);
    EXPECT_EQ(run(MirrorPoseJob{&m.tables, m.out.span(), twice.span()}), ErrorCode::ok);
    for (std::size_t j = 0; j < m.local.size(); ++j) {
      EXPECT_LT(test::angle_between(twice.span().get(j).rotation, m.local[j].rotation), 16 * test::kEps) << j;
      EXPECT_TRUE(test::is_near(twice.span().get(j).translation, m.local[j].translation, 16 * test::kEps)) << j;
    }
  }
}

TEST(mirror_pose, a_skeleton_of_no_joints_and_one_of_many_allocate_nothing) {
  const Skeleton biped = scenes::biped();
  const MirrorTables none = make_mirror_tables({}), many = make_mirror_tables(make_mirror_map(biped).joints);
  test::PoseBuffer empty(0), empty_out(0), pose(67), out(67);
  for (std::size_t j = 0; j < 67; ++j) pose.span().set(j, biped.rest[j]);
  const test::AllocationCounter counter;
  EXPECT_EQ(run(MirrorPoseJob{&none, empty.span(), empty_out.span()}), ErrorCode::ok);
  EXPECT_EQ(run(MirrorPoseJob{&many, pose.span(), out.span()}), ErrorCode::ok);
  EXPECT_EQ(counter.count(), 0u);
  for (std::size_t j = 0; j < 67; ++j)
    EXPECT_TRUE(test::is_near(out.span().get(j).translation, biped.rest[j].translation, 1e-6)) << j;
}

}  // namespace
}  // namespace sinew
