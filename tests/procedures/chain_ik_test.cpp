// SPDX-License-Identifier: MIT
#include "runtime/procedures/chain_ik.h"

#include <gtest/gtest.h>

#include <array>
#include <numbers>

#include "tests/procedures/chains.h"
#include "tests/support/allocation_counter.h"

namespace sinew::test {
namespace {

using V = Vec3<double>;

TEST(chain_ik, every_solver_reaches_targets_in_reach_and_bones_keep_their_lengths) {
  for (const ChainSolver solver : kSolvers)
    for (const std::uint32_t count : {3u, 8u, 28u}) {
      FixedRandom random(count);
      int reached = 0;
      for (int i = 0; i < 50; ++i) {
        Posed posed = random_chain(random, count);
        const V target = random.direction<double>() * random.in(0.3, 0.9);
        const std::vector joints = all_joints(count);
        const std::array effectors{ChainEffector{.joint = count, .target = target}};
        const IkResult result = ChainRun{posed,
                                         {.joints = joints,
                                          .effectors = effectors,
                                          .solver = solver,
                                          .iterations = 100,
                                          .tolerance = solver == ChainSolver::ccd ? 0.02f : 1e-4f}}();
        EXPECT_NEAR(result.metres_left, distance(posed.place(count), target), 2e-6);
        if (result.status == IkStatus::reached) ++reached;
        for (std::uint32_t j = 1; j <= count; ++j)
          EXPECT_NEAR(distance(posed.place(j), posed.place(j - 1)), 1.0 / count, 1e-6);
      }
      EXPECT_GE(reached, 48) << static_cast<int>(solver) << ' ' << count;
    }
}

TEST(chain_ik, parents_may_have_any_scale) {
  for (const ChainSolver solver : kSolvers)
    for (const Vec3<float>& scale : {Vec3<float>(2, 2, 2), Vec3<float>(1, 2, 1), Vec3<float>(-3, -3, -3)}) {
      FixedRandom random(2);
      for (int i = 0; i < 20; ++i) {
        Posed posed = random_chain(random, 6);
        Transform root = posed.get(0);
        root.scale = scale;
        root.translation = random.vec3(-100, 100);
        posed.set(0, root);
        std::vector<ChainIkJoint> joints = all_joints(6);
        joints.erase(joints.begin());  // joint 0 is the parent
        const V local = V(posed.get(1).translation) + random.direction<double>() * random.in(0.3, 0.7);
        const std::array effectors{ChainEffector{.joint = 6, .target = transform_point(posed.model(0), local)}};
        const IkResult result = ChainRun{
            posed,
            {.joints = joints, .effectors = effectors, .solver = solver, .iterations = 200, .tolerance = 1e-3f}}();
        EXPECT_EQ(result.status, IkStatus::reached)
            << static_cast<int>(solver) << ' ' << scale.x << ' ' << result.metres_left;
        EXPECT_LT(distance(posed.place(6), effectors[0].target), 1.1e-3);
      }
    }
}

TEST(chain_ik, the_end_takes_its_rotation) {
  FixedRandom random(3);
  for (const ChainSolver solver : kSolvers)
    for (int i = 0; i < 20; ++i) {
      Posed posed = random_chain(random, 6);
      const std::vector joints = all_joints(7);  // the last joint turns, too
      const std::array effectors{ChainEffector{.joint = 6,
                                               .target = random.direction<double>() * 0.6,
                                               .rotation = random.rotation(),
                                               .rotation_weight = 1.0f}};
      const IkResult result =
          ChainRun{posed, {.joints = joints, .effectors = effectors, .solver = solver, .iterations = 200}}();
      EXPECT_EQ(result.status, IkStatus::reached)
          << static_cast<int>(solver) << ' ' << result.metres_left << ' ' << result.radians_left;
      EXPECT_LT(angle_between(posed.rotation(6), effectors[0].rotation), 1.1e-3);
    }
}

/// Hips, spine and head, two arms, two legs: joint 0 is the hips.
struct Body : Posed {
  enum : std::uint32_t {
    hips,
    spine,
    thigh_l,
    thigh_r,
    chest,
    shin_l,
    shin_r,
    head,
    arm_l,
    arm_r,
    foot_l,
    foot_r,
    elbow_l,
    elbow_r,
    hand_l,
    hand_r
  };
  Body() : Posed(skeleton_of({kNone, 0, 0, 0, 1, 2, 3, 4, 4, 4, 5, 6, 8, 9, 12, 13})) {
    const Vec3<float> places[] = {{0, 1, 0},         {0, 0.2f, 0},       {0.1f, 0, 0},       {-0.1f, 0, 0},
                                  {0, 0.2f, 0.02f},  {0, -0.5f, 0.05f},  {0, -0.5f, 0.05f},  {0, 0.3f, 0},
                                  {0.2f, 0.1f, 0},   {-0.2f, 0.1f, 0},   {0, -0.5f, -0.05f}, {0, -0.5f, -0.05f},
                                  {0.3f, 0, -0.03f}, {-0.3f, 0, -0.03f}, {0.25f, 0, 0.03f},  {-0.25f, 0, 0.03f}};
    for (std::uint32_t j = 0; j < 16; ++j) set(j, {.translation = places[j]});
  }
};

TEST(chain_ik, a_body_keeps_its_feet_while_its_hands_reach_down) {
  for (const ChainSolver solver : kSolvers) {
    Body body;
    std::vector<ChainIkJoint> joints;
    for (const std::uint32_t j : {0u, 1u, 2u, 3u, 4u, 5u, 6u, 8u, 9u, 12u, 13u})
      joints.push_back({.joint = j, .moves = j == 0});
    const std::array effectors{ChainEffector{.joint = Body::foot_l, .target = body.place(Body::foot_l), .weight = 10},
                               ChainEffector{.joint = Body::foot_r, .target = body.place(Body::foot_r), .weight = 10},
                               ChainEffector{.joint = Body::hand_l, .target = {0.2, 0.5, 0.5}},
                               ChainEffector{.joint = Body::hand_r, .target = {-0.2, 0.5, 0.5}}};
    const IkResult result = ChainRun{
        body, {.joints = joints, .effectors = effectors, .solver = solver, .iterations = 300, .tolerance = 2e-3f}}();
    EXPECT_EQ(result.status, IkStatus::reached) << static_cast<int>(solver) << ' ' << result.metres_left;
    for (const ChainEffector& effector : effectors)
      EXPECT_LT(distance(body.place(effector.joint), effector.target), 2.1e-3);
    EXPECT_LT(body.place(Body::hips).y, 1.0) << "the hips came down";
  }
}

TEST(chain_ik, the_heavier_of_two_effectors_that_cannot_both_be_met_wins) {
  for (const ChainSolver solver : kSolvers) {
    FixedRandom random(4);
    Posed posed = random_chain(random, 4);
    const std::vector joints = all_joints(4);
    const std::array effectors{ChainEffector{.joint = 4, .target = {0.6, 0, 0}, .weight = 100},
                               ChainEffector{.joint = 4, .target = {-0.6, 0, 0}, .weight = 0.1f}};
    const IkResult result =
        ChainRun{posed, {.joints = joints, .effectors = effectors, .solver = solver, .iterations = 100}}();
    EXPECT_EQ(result.status, IkStatus::limited);
    EXPECT_LT(distance(posed.place(4), effectors[0].target), 0.02) << static_cast<int>(solver);
  }
}

TEST(chain_ik, limits_hold_and_are_told) {
  JointLimit limit;
  limit.axes = quat_from_axis_angle(Vec3<float>(0, 0, 1), std::numbers::pi_v<float> / 2);  // its x is the bone, y
  limit.swing_y_rad = limit.swing_z_rad = 0.2f;
  const std::array limits{limit};
  for (const ChainSolver solver : kSolvers) {
    FixedRandom random(5);
    Posed posed = random_chain(random, 5, 0.1);
    const std::vector joints = all_joints(5, 0);
    const std::array effectors{ChainEffector{.joint = 5, .target = {0.1, -0.5, 0}}};  // behind what limits allow
    const IkResult result = ChainRun{
        posed, {.joints = joints, .limits = limits, .effectors = effectors, .solver = solver, .iterations = 60}}();
    EXPECT_EQ(result.status, IkStatus::limited);
    EXPECT_GT(result.metres_left, 0.3f);
    for (std::uint32_t j = 0; j < 5; ++j)
      EXPECT_LT(angle_between(posed.get(j).rotation, quat_identity<float>()), 0.2001)
          << static_cast<int>(solver) << ' ' << j;
  }
}

TEST(chain_ik, targets_out_of_reach_stretch_the_chain_and_are_told) {
  for (const ChainSolver solver : kSolvers) {
    FixedRandom random(6);
    Posed posed = random_chain(random, 5);
    const std::vector joints = all_joints(5);
    const std::array effectors{ChainEffector{.joint = 5, .target = {1, 1, 0}}};
    const IkResult result =
        ChainRun{posed, {.joints = joints, .effectors = effectors, .solver = solver, .iterations = 200}}();
    EXPECT_EQ(result.status, IkStatus::unreachable);
    EXPECT_NEAR(result.metres_left, std::sqrt(2.0) - 1.0, 2e-3) << static_cast<int>(solver);
  }
}

TEST(chain_ik, a_chain_that_is_straight_towards_its_target_bends) {
  for (const ChainSolver solver : kSolvers) {
    FixedRandom random(7);
    Posed posed = random_chain(random, 4, 0.0);
    const std::vector joints = all_joints(4);
    const std::array effectors{ChainEffector{.joint = 4, .target = {0, 0.6, 0}}};
    EXPECT_EQ(
        (ChainRun{posed, {.joints = joints, .effectors = effectors, .solver = solver, .iterations = 100}}()).status,
        IkStatus::reached)
        << static_cast<int>(solver);
  }
}

TEST(chain_ik, bones_may_change_their_lengths_from_frame_to_frame) {
  for (const ChainSolver solver : kSolvers) {
    FixedRandom random(8);
    Posed posed = random_chain(random, 5);
    for (std::uint32_t j = 1; j <= 5; ++j) {
      Transform t = posed.get(j);
      t.translation *= static_cast<float>(random.in(0.5, 2.0));
      posed.set(j, t);
    }
    const std::vector joints = all_joints(5);
    const std::array effectors{ChainEffector{.joint = 5, .target = {0.3, 0.4, 0.2}}};
    EXPECT_EQ(
        (ChainRun{posed, {.joints = joints, .effectors = effectors, .solver = solver, .iterations = 100}}()).status,
        IkStatus::reached);
  }
}

TEST(chain_ik, weights_mix_and_zero_keeps_every_bit) {
  FixedRandom random(9);
  Posed posed = random_chain(random, 4);
  const std::vector<float> before = posed.bits();
  const std::vector joints = all_joints(4);
  const std::array effectors{ChainEffector{.joint = 4, .target = {0.3, 0.4, 0.2}}};
  ChainRun solve{posed, {.joints = joints, .effectors = effectors, .weight = 0.0f}};
  EXPECT_EQ(solve(), IkResult{});
  EXPECT_EQ(posed.bits(), before);
  solve.goal.weight = 0.5f;
  EXPECT_EQ(solve().status, IkStatus::limited);
  EXPECT_NE(posed.bits(), before);
}

TEST(chain_ik, equal_runs_have_equal_bits) {
  for (const ChainSolver solver : kSolvers) {
    FixedRandom random(10);
    const Posed start = random_chain(random, 8);
    const std::vector joints = all_joints(8);
    const std::array effectors{ChainEffector{.joint = 8, .target = {0.3, 0.4, 0.2}}};
    std::vector<float> first;
    for (int i = 0; i < 100; ++i) {
      Posed posed = start;
      ChainRun{posed, {.joints = joints, .effectors = effectors, .solver = solver}}();
      if (i == 0) first = posed.bits();
      EXPECT_EQ(posed.bits(), first);
    }
  }
}

TEST(chain_ik, refuses_what_it_cannot_solve_and_allocates_nothing) {
  FixedRandom random(11);
  Posed posed = random_chain(random, 12);
  const std::vector joints = all_joints(12);
  const std::array effectors{ChainEffector{.joint = 12, .target = {0.3, 0.4, 0.2}, .rotation_weight = 1.0f},
                             ChainEffector{.joint = 6, .target = {0.1, 0.2, 0.1}}};
  struct alignas(64) Bytes {
    std::byte bytes[64];
  };
  std::vector<Bytes> memory(8192);
  const std::span<std::byte> all{memory[0].bytes, memory.size() * 64};
  for (const ChainSolver solver : kSolvers) {
    const ChainGoal goal{.joints = joints, .effectors = effectors, .solver = solver, .iterations = 8};
    const ChainIkJob job{&posed.skeleton, posed.pose.span(), goal, all};
    ASSERT_EQ(check(job), ErrorCode::ok);
    AllocationCounter counter;
    run_unchecked(job);
    EXPECT_EQ(counter.count(), 0u) << static_cast<int>(solver);
  }
  const auto code = [&](auto change) {
    std::vector<ChainIkJoint> own_joints = joints;
    std::vector<ChainEffector> own(effectors.begin(), effectors.end());
    ChainIkJob job{&posed.skeleton, posed.pose.span(), {}, all};
    change(job, own_joints, own);
    job.goal.joints = own_joints;
    job.goal.effectors = own;
    return check(job);
  };
  EXPECT_EQ(code([](auto&, auto&, auto&) {}), ErrorCode::ok);
  EXPECT_EQ(code([](auto& job, auto&, auto&) { job.memory = job.memory.first(64); }), ErrorCode::size_mismatch);
  EXPECT_EQ(code([](auto& job, auto&, auto&) { job.memory = job.memory.subspan(4); }), ErrorCode::size_mismatch);
  EXPECT_EQ(code([](auto& job, auto&, auto&) { job.skeleton = nullptr; }), ErrorCode::size_mismatch);
  EXPECT_EQ(code([](auto&, auto& j, auto&) { j.clear(); }), ErrorCode::unsupported);
  EXPECT_EQ(code([](auto&, auto& j, auto&) { j[1].joint = 13; }), ErrorCode::index_out_of_range);
  EXPECT_EQ(code([](auto&, auto& j, auto&) { j[1].limit = 0; }), ErrorCode::index_out_of_range);
  EXPECT_EQ(code([](auto&, auto& j, auto&) { j[1].joint = 0; }), ErrorCode::parents_not_first);
  EXPECT_EQ(code([](auto&, auto&, auto& e) { e[0].joint = 99; }), ErrorCode::index_out_of_range);
  EXPECT_EQ(code([](auto&, auto&, auto& e) { e.resize(65, e[0]); }), ErrorCode::unsupported);
  EXPECT_EQ(code([](auto&, auto&, auto& e) { e[0].target.x = std::nan(""); }), ErrorCode::not_finite);
  EXPECT_EQ(code([](auto&, auto&, auto& e) { e[0].weight = -1; }), ErrorCode::negative_weight);
  EXPECT_EQ(code([](auto&, auto&, auto& e) { e[0].rotation.w = 3; }), ErrorCode::not_normalised);
  EXPECT_EQ(code([](auto& job, auto&, auto&) { job.goal.weight = 2; }), ErrorCode::not_a_fraction);
}

}  // namespace
}  // namespace sinew::test
