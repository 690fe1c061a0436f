// SPDX-License-Identifier: MIT
#include "runtime/pose/local_to_model.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "runtime/base/same_bits.h"
#include "tests/support/fixed_random.h"
#include "tests/support/near.h"
#include "tests/support/simd_targets.h"

namespace sinew {
namespace {

struct alignas(64) Block {
  float floats[16];
};

/// A skeleton, a pose over it and room for the model matrices.
struct Rig {
  Skeleton skeleton;
  std::vector<Block> memory;
  PoseSpan pose;
  std::vector<Affine> model;

  explicit Rig(std::vector<std::uint32_t> parents) {
    const std::size_t count = parents.size();
    skeleton.parents = std::move(parents);
    skeleton.rest.resize(count);
    skeleton.fixed_matrix_of.assign(count, kNone);
    memory.resize(PoseSpan::floats_for(count) / 16 + 1);
    pose = pose_over({memory[0].floats, PoseSpan::floats_for(count)}, count);
    for (std::size_t j = 0; j < count; ++j) pose.set(j, {});
    model.resize(count);
  }
  LocalToModelJob job() { return {.skeleton = &skeleton, .local = pose, .model = model}; }
};

std::vector<std::uint32_t> chain(std::uint32_t count) {
  std::vector<std::uint32_t> parents(count);
  for (std::uint32_t j = 0; j < count; ++j) parents[j] = j == 0 ? kNone : j - 1;
  return parents;
}

TEST(local_to_model, rejects_short_and_overlapping_buffers) {
  Rig rig(chain(3));
  EXPECT_EQ(check(rig.job()), ErrorCode::ok);
  auto job = rig.job();
  job.skeleton = nullptr;
  EXPECT_EQ(check(job), ErrorCode::size_mismatch);
  job = rig.job();
  job.model = job.model.first(2);
  EXPECT_EQ(check(job), ErrorCode::size_mismatch);
  job = rig.job();
  job.local.joint_count = 2;
  EXPECT_EQ(check(job), ErrorCode::size_mismatch);
  job = rig.job();
  job.model = {reinterpret_cast<Affine*>(rig.pose.planes), 3};
  EXPECT_EQ(check(job), ErrorCode::overlapping_buffers);
}

TEST(local_to_model, an_empty_skeleton_is_no_work) {
  Rig rig({});
  EXPECT_EQ(check(rig.job()), ErrorCode::ok);
  EXPECT_EQ(run(rig.job()), ErrorCode::ok);
  LocalToModelJob without_memory = rig.job();
  without_memory.local.planes = nullptr;
  without_memory.model = {};
  EXPECT_EQ(check(without_memory), ErrorCode::ok);
}

TEST(local_to_model, quarter_turns_along_a_chain_end_where_drawn_by_hand) {
  Rig rig(chain(3));
  const float h = std::sqrt(0.5f);
  rig.pose.set(0, {{1, 0, 0}, quat_xyzw(0.0f, 0.0f, h, h), {1, 1, 1}});  // at (1,0,0), turned 90 degrees about z
  rig.pose.set(1, {{2, 0, 0}, quat_xyzw(0.0f, 0.0f, h, h), {3, 1, 1}});  // two along the turned x: (1,2,0)
  rig.pose.set(2, {{1, 0, 0}, quat_identity<float>(), {1, 1, 1}});       // three along -x: (-2,2,0)
  EXPECT_EQ(run(rig.job()), ErrorCode::ok);
  EXPECT_TRUE(test::is_near(translation_of(rig.model[1]), {1, 2, 0}, 1e-6));
  EXPECT_TRUE(test::is_near(translation_of(rig.model[2]), {-2, 2, 0}, 1e-6));
}

TEST(local_to_model, G50_a_fixed_matrix_replaces_the_pose_verbatim) {
  Rig rig(chain(2));
  Affine shear;
  shear.row[0] = {1, 0.5f, 0, 7};
  rig.skeleton.fixed_matrices = {shear};
  rig.skeleton.fixed_matrix_of[1] = 0;
  rig.pose.set(0, {{0, 3, 0}, quat_identity<float>(), {1, 1, 1}});
  rig.pose.set(1, {{9, 9, 9}, quat_identity<float>(), {9, 9, 9}});
  EXPECT_EQ(run(rig.job()), ErrorCode::ok);
  EXPECT_EQ(rig.model[1].row[0], glm::vec4(1, 0.5f, 0, 7));
  EXPECT_EQ(rig.model[1].row[1], glm::vec4(0, 1, 0, 3));
}

TEST(local_to_model, root_stands_above_all_root_joints) {
  Rig rig({kNone, kNone, 1});
  auto job = rig.job();
  job.root.row[1].w = 5;
  EXPECT_EQ(run(job), ErrorCode::ok);
  for (const auto& m : rig.model) EXPECT_EQ(m.row[1].w, 5.0f);
}

TEST(local_to_model, G49_non_uniform_scale_above_a_rotation_shears) {
  Rig rig(chain(2));
  const float h = std::sqrt(0.5f);
  rig.pose.set(0, {{0, 0, 0}, quat_identity<float>(), {2, 1, 1}});
  rig.pose.set(1, {{0, 0, 0}, quat_xyzw(0.0f, 0.0f, std::sin(0.3926991f), std::cos(0.3926991f)), {1, 1, 1}});
  EXPECT_EQ(run(rig.job()), ErrorCode::ok);
  // diag(2,1,1) times a turn of 45 degrees: no rotation and scale of its own gives this
  EXPECT_NEAR(rig.model[1].row[0].x, 2 * h, 1e-6f);
  EXPECT_NEAR(rig.model[1].row[0].y, -2 * h, 1e-6f);
  EXPECT_NEAR(rig.model[1].row[1].x, h, 1e-6f);
  EXPECT_NEAR(rig.model[1].row[1].y, h, 1e-6f);
}

TEST(local_to_model, random_trees_agree_with_double_within_a_few_roundings_per_level) {
  test::FixedRandom random(7);
  for (int repeat = 0; repeat < 20; ++repeat) {
    const std::uint32_t count = 1 + random.below(300);
    std::vector<std::uint32_t> parents(count, kNone);
    std::vector<int> depth(count, 1);
    for (std::uint32_t j = 1; j < count; ++j) {
      if (random.below(10) == 0) continue;  // another root
      parents[j] = random.below(j);
      depth[j] = depth[parents[j]] + 1;
    }
    Rig rig(parents);
    std::vector<Affined> truth(count);
    for (std::uint32_t j = 0; j < count; ++j) {
      const Transform t = random.transform(0.8, 1.25);
      rig.pose.set(j, t);
      const Transformd exact{Vec3<double>(t.translation), quat_cast<double>(t.rotation), Vec3<double>(t.scale)};
      const Affined local = affine_from_transform(exact);
      truth[j] = parents[j] == kNone ? local : truth[parents[j]] * local;
    }
    EXPECT_EQ(run(rig.job()), ErrorCode::ok);
    for (std::uint32_t j = 0; j < count; ++j) {
      double size = 1;
      for (const auto& row : truth[j].row)
        for (int c = 0; c < 4; ++c) size = std::max(size, std::abs(row[c]));
      EXPECT_TRUE(test::is_near(affine_cast<double>(rig.model[j]), truth[j], 16 * test::kEps * depth[j] * size)) << j;
    }
  }
}

TEST(local_to_model, N28_joints_have_the_bits_of_plain_products_however_far_their_parents_are) {
  test::FixedRandom random(78);
  for (const std::int64_t only : test::simd_targets()) {
    const test::OnlyTarget target(only);
    for (std::uint32_t farthest = 1; farthest <= 80; farthest = farthest < 10 ? farthest + 1 : 2 * farthest) {
      const std::uint32_t count = 130 + random.below(30);
      std::vector<std::uint32_t> parents(count, kNone);
      for (std::uint32_t j = 1; j < count; ++j) parents[j] = random.below(20) == 0 ? kNone : j - std::min(j, farthest);
      Rig rig(parents);
      std::vector<Affine> local(count);
      for (std::uint32_t j = 0; j < count; ++j) {
        rig.pose.set(j, random.transform(0.8, 1.25));
        local[j] = affine_from_transform(rig.pose.get(j));
        if (random.below(10) != 0) continue;
        local[j].row[0] += glm::vec4(0.25f, 0.5f, 0, 1);
        rig.skeleton.fixed_matrix_of[j] = static_cast<std::uint32_t>(rig.skeleton.fixed_matrices.size());
        rig.skeleton.fixed_matrices.push_back(local[j]);
      }
      LocalToModelJob job = rig.job();
      job.root = affine_from_transform(random.transform());
      EXPECT_EQ(run(job), ErrorCode::ok);
      for (std::uint32_t j = 0; j < count; ++j) {
        const Affine plain = (parents[j] == kNone ? job.root : rig.model[parents[j]]) * local[j];
        EXPECT_TRUE(same_bits<Affine>({&plain, 1}, {&rig.model[j], 1}))
            << "joint " << j << ", parents " << farthest << " before";
      }
    }
  }
}

TEST(local_to_model, P01_some_joints_have_the_bits_of_all_and_the_others_are_not_touched) {
  test::FixedRandom random(77);
  const std::vector<std::int64_t> targets = test::simd_targets();
  for (std::size_t round = 0; round < 60; ++round) {
    const test::OnlyTarget target(targets[round % targets.size()]);
    const std::uint32_t count = 1 + random.below(200);
    std::vector<std::uint32_t> parents(count, kNone);
    const std::uint32_t farthest = round % 2 == 0 ? count : 1 + random.below(12);
    for (std::uint32_t j = 1; j < count; ++j)
      parents[j] = random.below(8) == 0 ? kNone : j - 1 - random.below(std::min(j, farthest));
    Rig rig(parents);
    for (std::uint32_t j = 0; j < count; ++j) rig.pose.set(j, random.transform());
    if (round % 3 == 0) {
      rig.skeleton.fixed_matrices.push_back(affine_from(glm::mat3(2.0f), {3, 2, 1}));
      rig.skeleton.fixed_matrix_of[count / 2] = 0;
    }
    EXPECT_EQ(run(rig.job()), ErrorCode::ok);
    const std::vector<Affine> whole = rig.model;
    std::vector<std::uint32_t> some;
    std::vector<bool> chosen(count);
    for (std::uint32_t j = 0; j < count; ++j)
      if ((parents[j] != kNone && chosen[parents[j]]) || random.below(4) == 0) {
        chosen[j] = true;
        some.push_back(j);
      }
    if (some.empty()) continue;
    for (const std::uint32_t j : some) rig.model[j] = {};
    LocalToModelJob job = rig.job();
    job.only = some;
    ASSERT_EQ(run(job), ErrorCode::ok);
    EXPECT_TRUE(same_bits<Affine>(rig.model, whole)) << round;
  }
  Rig rig(chain(3));
  const std::uint32_t beyond = 3;
  LocalToModelJob job = rig.job();
  job.only = {&beyond, 1};
  EXPECT_EQ(check(job), ErrorCode::index_out_of_range);
}

TEST(local_to_model, poses_without_memory_are_refused_from_one_joint_on) {
  for (const std::uint32_t joints : {1u, 2u}) {
    Rig rig(chain(joints));
    LocalToModelJob job = rig.job();
    job.local.planes = nullptr;
    EXPECT_EQ(check(job), ErrorCode::size_mismatch) << joints;
  }
}

}  // namespace
}  // namespace sinew
