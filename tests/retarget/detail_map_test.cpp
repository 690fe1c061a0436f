// SPDX-License-Identifier: MIT
#include "runtime/retarget/detail_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "runtime/animation/truth_pose.h"
#include "runtime/base/same_bits.h"
#include "runtime/math/axis_angle.h"
#include "runtime/math/decompose.h"
#include "runtime/math/inverse.h"
#include "tests/scenes/skeletons.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/fixed_random.h"
#include "tests/support/near.h"
#include "tests/support/tiny_assets.h"

namespace sinew {
namespace {

std::vector<Affined> model_of(const Skeleton& skeleton, const PoseSpan& local) {
  std::vector<Transformd> pose;
  for (std::size_t j = 0; j < skeleton.joint_count(); ++j) pose.push_back(in_double(local.get(j)));
  std::vector<Affined> model(pose.size());
  model_from_local(skeleton, pose, model);
  return model;
}

std::vector<Affine> in_float(const std::vector<Affined>& matrices) {
  std::vector<Affine> out;
  for (const Affined& m : matrices) out.push_back(affine_cast<float>(m));
  return out;
}

test::PoseBuffer rest_of(const Skeleton& skeleton) {
  test::PoseBuffer pose(skeleton.joint_count());
  for (std::size_t j = 0; j < skeleton.joint_count(); ++j) pose.span().set(j, skeleton.rest[j]);
  return pose;
}

/// A character of 67 joints, and a ragdoll of every third one, whose bodies have axes and centers of their own.
struct Ragdoll {
  Skeleton fine = scenes::biped(), coarse;
  std::vector<std::uint32_t> fine_of;  // [coarse]

  explicit Ragdoll(std::uint64_t seed) {
    test::FixedRandom random(seed);
    std::vector<std::uint32_t> parents, body_of(fine.joint_count(), kNone);
    std::vector<Affined> neutral;
    test::PoseBuffer rest = rest_of(fine);
    const std::vector<Affined> model = model_of(fine, rest.span());
    for (std::uint32_t j = 0; j < fine.joint_count(); ++j) {
      if (j % 3 != 0) continue;
      std::uint32_t above = fine.parents[j];
      while (above != kNone && body_of[above] == kNone) above = fine.parents[above];
      body_of[j] = static_cast<std::uint32_t>(fine_of.size());
      parents.push_back(above == kNone ? kNone : body_of[above]);
      fine_of.push_back(j);
      const Transform offset{random.vec3(-0.1, 0.1), random.rotation_by(2.0), glm::vec3(1.0f)};
      neutral.push_back(model[j] * affine_from_transform(in_double(offset)));
    }
    coarse.parents = parents;
    for (std::size_t c = 0; c < parents.size(); ++c) {
      fine.names[fine_of[c]] = "body " + std::to_string(c);
      coarse.names.push_back(fine.names[fine_of[c]]);
      const Affined local = parents[c] == kNone ? neutral[c] : *inverse_of(neutral[parents[c]]) * neutral[c];
      const Transformd t = decompose_trs(local).transform;
      coarse.rest.push_back({glm::vec3(t.translation), quat_cast<float>(t.rotation), glm::vec3(1.0f)});
      coarse.fixed_matrix_of.push_back(kNone);
    }
  }
  DetailMap map() const { return *make_detail_map(coarse, fine); }

  test::PoseBuffer random_pose(std::uint64_t seed) const {
    test::FixedRandom random(seed);
    test::PoseBuffer pose(fine.joint_count());
    for (std::size_t j = 0; j < fine.joint_count(); ++j) {
      Transform t = fine.rest[j];
      t.rotation = random.rotation_by(0.6) * t.rotation;
      pose.span().set(j, t);
    }
    return pose;
  }
};

double difference(const Affined& a, const Affined& b) {
  double most = 0.0;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 4; ++c) most = std::max(most, std::abs(a.row[r][c] - b.row[r][c]));
  return most;
}

TEST(detail_map, an_animated_pose_that_the_bodies_follow_comes_back) {
  for (std::uint64_t seed = 1; seed < 6; ++seed) {
    const Ragdoll ragdoll(seed);
    const DetailMap map = ragdoll.map();
    ASSERT_EQ(map.pairs.size(), ragdoll.fine_of.size());
    test::PoseBuffer pose = ragdoll.random_pose(seed + 10);
    const std::vector<Affined> before = model_of(ragdoll.fine, pose.span());
    std::vector<Affine> bodies(ragdoll.coarse.joint_count());
    ASSERT_EQ(coarse_from_fine(map, ragdoll.coarse, in_float(before), bodies), ErrorCode::ok);
    std::vector<Affined> scratch(2 * ragdoll.fine.joint_count());
    ASSERT_EQ(fine_from_coarse(map, ragdoll.fine, bodies, pose.span(), scratch), ErrorCode::ok);
    const std::vector<Affined> after = model_of(ragdoll.fine, pose.span());
    for (std::size_t j = 0; j < after.size(); ++j) EXPECT_LT(difference(before[j], after[j]), 8e-6) << seed << ' ' << j;
  }
}

TEST(detail_map, mapped_joints_stand_where_their_bodies_are_and_others_keep_their_local_pose) {
  const Ragdoll ragdoll(7);
  const DetailMap map = ragdoll.map();
  test::FixedRandom random(70);
  std::vector<Affined> scratch(2 * ragdoll.fine.joint_count());
  for (int round = 0; round < 20; ++round) {
    std::vector<Affine> bodies;
    for (std::size_t c = 0; c < ragdoll.coarse.joint_count(); ++c)
      bodies.push_back(affine_from_transform(Transform{random.vec3(-1, 1), random.rotation_by(3.0), glm::vec3(1.0f)}));
    test::PoseBuffer pose = ragdoll.random_pose(71), animated = pose;
    const test::AllocationCounter allocations;
    ASSERT_EQ(fine_from_coarse(map, ragdoll.fine, bodies, pose.span(), scratch), ErrorCode::ok);
    EXPECT_EQ(allocations.count(), 0u);
    const std::vector<Affined> model = model_of(ragdoll.fine, pose.span());
    for (const DetailMap::Pair& pair : map.pairs)
      EXPECT_LT(difference(model[pair.fine], affine_cast<double>(bodies[pair.coarse]) * pair.fine_in_coarse), 2e-5);
    for (std::size_t j = 0; j < ragdoll.fine.joint_count(); ++j) {
      if (map.pair_of_fine[j] != kNone || map.chain_of_fine[j] != kNone) continue;
      EXPECT_TRUE(same_bits(pose.span().get(j), animated.span().get(j))) << j;
    }

    test::PoseBuffer kept = ragdoll.random_pose(71);
    ASSERT_EQ(fine_from_coarse(map, ragdoll.fine, bodies, kept.span(), scratch, BodyPlaces::keep_lengths),
              ErrorCode::ok);
    const std::vector<Affined> rigid = model_of(ragdoll.fine, kept.span());
    for (const DetailMap::Pair& pair : map.pairs) {
      const bool is_top = ragdoll.coarse.parents[pair.coarse] == kNone;
      EXPECT_LT(test::angle_between(decompose_trs(rigid[pair.fine]).transform.rotation,
                                    decompose_trs(model[pair.fine]).transform.rotation),
                2e-5);
      EXPECT_EQ(kept.span().get(pair.fine).translation == animated.span().get(pair.fine).translation, !is_top);
    }
  }
}

/// A spine of five joints: bodies at the first and the last, which bend it by 80 degrees along an even arc.
TEST(detail_map, a_spine_between_two_bodies_bends_evenly) {
  Skeleton fine = test::chain_skeleton(5), coarse = test::chain_skeleton(2);
  for (std::size_t j = 1; j < 5; ++j) fine.rest[j].translation = {0, 1, 0};
  coarse.rest[1].translation = {0, 4, 0};
  DetailMapOptions options;
  options.pairs = {{0, 0}, {1, 4}};
  const DetailMap map = *make_detail_map(coarse, fine, options);
  ASSERT_EQ(map.chains.size(), 1u);
  EXPECT_EQ(map.chains[0].joints, (std::vector<std::uint32_t>{1, 2, 3}));
  const auto turn = [](double degrees) { return quat_from_axis_angle(Vec3<double>(0, 0, 1), degrees * M_PI / 180); };
  Vec3<double> place(0, 1, 0);
  for (int i = 1; i < 4; ++i) place += turn(20.0 * i) * Vec3<double>(0, 1, 0);
  const std::vector<Affine> bodies = {
      Affine{}, affine_from_transform(Transform{glm::vec3(place), quat_cast<float>(turn(80)), glm::vec3(1.0f)})};
  test::PoseBuffer pose = rest_of(fine);
  std::vector<Affined> scratch(10);
  ASSERT_EQ(fine_from_coarse(map, fine, bodies, pose.span(), scratch), ErrorCode::ok);
  for (std::size_t j = 1; j < 5; ++j) {
    EXPECT_LT(test::angle_between(quat_cast<double>(pose.span().get(j).rotation), turn(20)), 1e-6) << j;
    EXPECT_TRUE(test::is_near(pose.span().get(j).translation, glm::vec3(0, 1, 0), 1e-6)) << j;
  }
}

TEST(detail_map, wrong_joints_sizes_and_numbers_are_refused) {
  const Skeleton two = test::chain_skeleton(2), three = test::chain_skeleton(3);
  const auto code = [&](std::vector<std::array<std::uint32_t, 2>> pairs) {
    const auto map = make_detail_map(two, three, {.pairs = std::move(pairs)});
    return map ? ErrorCode::ok : map.error();
  };
  EXPECT_EQ(code({{0, 0}, {1, 2}}), ErrorCode::ok);
  EXPECT_EQ(code({{2, 0}}), ErrorCode::index_out_of_range);
  EXPECT_EQ(code({{0, 3}}), ErrorCode::index_out_of_range);
  EXPECT_EQ(code({{0, 0}, {1, 0}}), ErrorCode::unsupported);
  EXPECT_EQ(code({{0, 0}, {0, 1}}), ErrorCode::unsupported);
  Skeleton flat = three, fixed = three;
  flat.rest[1].scale = {0, 1, 1};
  fixed.fixed_matrices.resize(1);
  fixed.fixed_matrix_of[2] = 0;
  EXPECT_EQ(make_detail_map(two, flat, {.pairs = {{0, 1}}}).error(), ErrorCode::unsupported);
  EXPECT_EQ(make_detail_map(two, fixed, {.pairs = {{0, 2}}}).error(), ErrorCode::unsupported);
  const std::vector<Affined> short_pose(1), lost(2, Affined{{{NAN, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}});
  EXPECT_EQ(make_detail_map(two, three, {.coarse_neutral = short_pose}).error(), ErrorCode::size_mismatch);
  EXPECT_EQ(make_detail_map(two, three, {.coarse_neutral = lost}).error(), ErrorCode::not_finite);

  const DetailMap map = *make_detail_map(two, three);
  std::vector<Affine> bodies(2), model(3);
  test::PoseBuffer pose = rest_of(three);
  std::vector<Affined> scratch(6);
  EXPECT_EQ(coarse_from_fine(map, two, bodies, bodies), ErrorCode::size_mismatch);
  EXPECT_EQ(fine_from_coarse(map, three, model, pose.span(), scratch), ErrorCode::size_mismatch);
  EXPECT_EQ(fine_from_coarse(map, three, bodies, pose.span(), std::span(scratch).first(5)), ErrorCode::size_mismatch);
  bodies[1].row[2].w = std::numeric_limits<float>::infinity();
  bodies[0].row[0].w = 5.0f;
  EXPECT_EQ(fine_from_coarse(map, three, bodies, pose.span(), scratch), ErrorCode::not_finite);
  EXPECT_EQ(pose.span().get(0).translation.x, 0.0f) << "the pose is unchanged";
}

}  // namespace
}  // namespace sinew
