// SPDX-License-Identifier: MIT
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "runtime/pose/pose_memory.h"
#include "runtime/procedures/aim.h"
#include "runtime/procedures/chain_ik.h"
#include "runtime/procedures/two_bone_ik.h"
#include "tests/bench/measure.h"
#include "tests/support/tiny_assets.h"

namespace sinew::bench {
namespace {

/// A chain of bones that is 1 m long and a little bent, and targets that it goes to in turns.
struct Chain {
  Skeleton skeleton;
  test::PoseBuffer pose, start;
  std::vector<Vec3<double>> targets;
  std::size_t turn = 0;

  explicit Chain(std::uint32_t bones) : skeleton(test::chain_skeleton(bones + 1)), pose(bones + 1), start(bones + 1) {
    test::FixedRandom random(bones);
    for (std::uint32_t j = 0; j <= bones; ++j)
      start.span().set(j, {.translation = {0, j == 0 ? 0.0f : 1.0f / static_cast<float>(bones), 0},
                           .rotation = random.rotation_by<float>(0.3)});
    for (int i = 0; i < 64; ++i) targets.push_back(random.direction<double>() * random.in(0.3, 0.9));
  }
  const Vec3<double>& next() {
    std::copy_n(start.span().planes, PoseSpan::floats_for(skeleton.joint_count()), pose.span().planes);
    return targets[turn++ % targets.size()];
  }
};

/// Limbs side by side below one root.
struct Limbs {
  Skeleton skeleton;
  test::PoseBuffer pose;
  std::vector<Vec3<double>> targets;
  std::vector<TwoBoneIkJob> jobs;
  std::size_t turn = 0;
  Affined above;

  explicit Limbs(std::uint32_t count) : skeleton(made(count)), pose(skeleton.joint_count()) {
    test::FixedRandom random(count);
    for (std::uint32_t j = 0; j < skeleton.joint_count(); ++j)
      pose.span().set(j, {.translation = {0, 0.5f, 0}, .rotation = random.rotation_by<float>(0.5)});
    const Vec3<double> root(0, 0.5, 0);
    for (int i = 0; i < 64; ++i) targets.push_back(root + random.direction<double>() * random.in(0.3, 0.9));
    above = affine_from_transform(Transformd{});
  }
  static Skeleton made(std::uint32_t count) {
    std::vector<std::uint32_t> parents{kNone};
    for (std::uint32_t level = 0; level < 3; ++level)
      for (std::uint32_t i = 0; i < count; ++i) parents.push_back(level == 0 ? 0 : 1 + (level - 1) * count + i);
    return test::skeleton_of(std::move(parents));
  }
  void solve(const Affined* matrix) {
    set_jobs(matrix);
    for (const TwoBoneIkJob& job : jobs) run_unchecked(job);
  }
  void solve_together() {
    set_jobs(&above);
    run_unchecked(TwoBoneIkLimbsJob{jobs});
  }
  void set_jobs(const Affined* matrix) {
    const auto count = static_cast<std::uint32_t>((skeleton.joint_count() - 1) / 3);
    jobs.resize(count);
    for (std::uint32_t i = 0; i < count; ++i) {
      TwoBoneIkJob& job = jobs[i];
      job = {&skeleton, pose.span()};
      job.goal.root = 1 + i;
      job.goal.middle = 1 + count + i;
      job.goal.tip = 1 + 2 * count + i;
      job.goal.target = targets[turn++ % targets.size()];
      job.goal.pole_kind = PoleKind::direction;
      job.goal.pole = {0, 0, 1};
      job.above = matrix;
    }
  }
};

void add_chain(ChainSolver solver, const char* name, std::uint32_t bones, std::uint32_t iterations) {
  struct Room : Chain {
    using Chain::Chain;
    std::vector<ChainIkJoint> joints;
    struct alignas(64) Block {
      std::byte bytes[64];
    };
    std::vector<Block> memory;
  };
  const auto room = std::make_shared<Room>(bones);
  for (std::uint32_t j = 0; j < bones; ++j) room->joints.push_back({.joint = j});
  std::array<ChainEffector, 1> effectors{};
  effectors[0].joint = bones;
  ChainGoal goal{
      .joints = room->joints, .effectors = effectors, .solver = solver, .iterations = iterations, .tolerance = 0.0f};
  const std::size_t bytes = chain_ik_bytes(room->skeleton, goal);
  room->memory.resize(bytes / 64);
  add("chain_ik/sinew/" + std::string(name) + "/" + std::to_string(bones) + "joints/" + std::to_string(iterations), 1,
      [room, goal, effectors, bytes]() mutable {
        effectors[0].target = room->next();
        goal.effectors = effectors;
        run_unchecked(ChainIkJob{&room->skeleton, room->pose.span(), goal, {room->memory[0].bytes, bytes}});
      });
}

}  // namespace

void add_ik() {
  for (const std::uint32_t count : {1u, 1024u}) {
    const auto limbs = std::make_shared<Limbs>(count);
    add("two_bone_ik/sinew/" + std::to_string(count), count, [limbs] { limbs->solve(&limbs->above); });
    if (count > 1) add("two_bone_ik/sinew/1024/together", count, [limbs] { limbs->solve_together(); });
    if (count == 1) add("two_bone_ik/sinew/1/composed", 1, [limbs] { limbs->solve(nullptr); });
  }
  for (const std::uint32_t count : {1u, 4u}) {
    const auto chain = std::make_shared<Chain>(count);
    std::vector<AimJoint> joints(count);
    for (std::uint32_t j = 0; j < count; ++j) joints[j].joint = j + 1;
    add("aim/sinew/" + std::to_string(count) + "joints", 1, [chain, joints] {
      AimGoal goal;
      goal.joints = joints;
      goal.target = chain->next() * 10.0;
      goal.pole = {0, 1, 0};
      run_unchecked(AimJob{&chain->skeleton, chain->pose.span(), goal});
    });
  }
  for (const std::uint32_t bones : {4u, 8u, 28u})
    for (const std::uint32_t iterations : {1u, 4u, 16u}) {
      add_chain(ChainSolver::ccd, "ccd", bones, iterations);
      add_chain(ChainSolver::fabrik, "fabrik", bones, iterations);
      add_chain(ChainSolver::damped, "damped", bones, iterations);
    }
}

}  // namespace sinew::bench
