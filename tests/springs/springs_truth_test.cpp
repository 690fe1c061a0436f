// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <bit>

#include "tests/springs/spring_stage.h"
#include "tests/springs/spring_truth.h"
#include "tests/support/fixed_random.h"
#include "tests/support/simd_targets.h"

namespace sinew {
namespace {

using test::SpringStage;
using test::SpringTruth;
using Vec = Vec3<double>;

Vec random_vector(test::FixedRandom& random, double size) {
  return {random.in(-size, size), random.in(-size, size), random.in(-size, size)};
}

Quat<float> random_turn(test::FixedRandom& random) {
  return quat_cast<float>(
      normalised(quat_xyzw(random.in(-1.0, 1.0), random.in(-1.0, 1.0), random.in(-1.0, 1.0), random.in(-1.0, 1.0))));
}

struct Character {
  Skeleton skeleton;
  SpringSetup setup;
};

/// Two chains.
const std::vector<std::uint32_t> kChains{kNone, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10};

/// Joints of one depth fill vectors of lanes, and some lanes are left. Parents are random, so chains branch.
std::vector<std::uint32_t> bush(std::uint64_t seed) {
  test::FixedRandom random(seed);
  std::vector<std::uint32_t> parents{kNone, 0, 0};
  for (std::uint32_t j = 3; j < 60; ++j)
    parents.push_back(j < 14 ? j % 3 : 3 + static_cast<std::uint32_t>(random.in(0.0, 1.0) * (j - 3)));
  return parents;
}

/// A tree with swinging and carried joints, colliders of every kind and a group with a centre.
Character random_character(const std::vector<std::uint32_t>& parents, std::uint64_t seed, bool sheared) {
  test::FixedRandom random(seed);
  Character out{test::skeleton_of(parents), {}};
  for (std::size_t j = 1; j < parents.size(); ++j) {
    Transform& rest = out.skeleton.rest[j];
    rest.translation = Vec3<float>(random_vector(random, 0.3)) + Vec3<float>(0.0f, -0.3f, 0.0f);
    rest.rotation = random_turn(random);
    rest.scale = Vec3<float>(static_cast<float>(random.in(0.5, 1.5)));
    if (sheared) rest.scale.y *= -0.7f;
  }
  using Kind = SpringCollider::Kind;
  for (const Kind kind : {Kind::sphere, Kind::capsule, Kind::plane})
    for (const bool inside : {false, true})
      out.setup.colliders.push_back({kind, random.in(0, 1) < 0.5 ? 1u : 2u, random_vector(random, 0.3),
                                     random_vector(random, 0.3), random_vector(random, 1.0),
                                     inside ? random.in(1.5, 2.5) : random.in(0.05, 0.3), inside});
  out.setup.groups = {{kNone, SpringGoal::rest, {0, 1, 2, 3, 4}}, {1, SpringGoal::pose, {0, 3, 5}}};
  for (std::uint32_t j = 3; j + 2 < parents.size(); ++j)
    if (j != 7)
      out.setup.joints.push_back({j, j % 2, Vec(out.skeleton.rest[j + 2].translation), random.in(0.1, 3.0),
                                  random.in(0.1, 0.9), random_vector(random, 0.5), random.in(0.0, 0.1),
                                  random.in(0.0, 1.0) < 0.5});
  return out;
}

/// Moves root and pose at random, and compares at every tick.
void expect_job_is_the_truth(const Character& character, std::uint64_t seed, int frames, double tolerance_m) {
  SpringSettings settings;
  settings.sleep_rad_per_s = 0.0;
  SpringStage stage(character.skeleton, character.setup, settings);
  SpringTruth truth(character.skeleton, character.setup);
  test::FixedRandom random(seed + 1);
  for (int frame = 0; frame <= frames; ++frame) {
    stage.move_root(test::figure_of_eight(frame / 60.0));
    for (Transform& local : stage.pose) local.rotation = normalised(local.rotation + random_turn(random) * 0.02f);
    truth.pose.clear();
    for (const Transform& local : stage.pose)
      truth.pose.push_back({Vec(local.translation), normalised(quat_cast<double>(local.rotation)), Vec(local.scale)});
    truth.root = stage.root;
    frame == 0 ? truth.reset() : truth.step(1.0 / 60.0);
    stage.frame(1.0 / 60.0);
    for (std::size_t s = 0; s < stage.tails.size(); ++s) {
      ASSERT_TRUE(test::is_near(stage.tails[s], truth.tails[s], tolerance_m)) << "frame " << frame << " joint " << s;
      const std::uint32_t j = character.setup.joints[s].joint;
      ASSERT_TRUE(test::same_rotation(stage.rotation(j), truth.pose[j].rotation, 1e-6)) << frame << s;
    }
  }
}

TEST(springs_truth, job_agrees_at_the_tick_rate) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    expect_job_is_the_truth(random_character(kChains, seed, false), seed, 120, 1e-9);
}

TEST(springs_truth, job_agrees_under_shear_and_mirroring) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    expect_job_is_the_truth(random_character(kChains, seed, true), seed, 120, 1e-9);
}

TEST(springs_truth, job_agrees_where_chains_branch_and_lanes_are_left) {
  for (std::uint64_t seed = 1; seed <= 6; ++seed)
    expect_job_is_the_truth(random_character(bush(seed), seed, seed % 3 == 0), seed, 30, 1e-9);
}

TEST(springs_truth, every_instruction_set_gives_the_same_bits) {
  for (const bool sheared : {false, true}) {
    const Character character = random_character(bush(1), 1, sheared);
    std::vector<std::uint64_t> first;
    for (const std::int64_t target : test::simd_targets()) {
      const test::OnlyTarget only(target);
      SpringStage stage(character.skeleton, character.setup);
      for (int frame = 0; frame <= 40; ++frame) {
        stage.move_root(test::figure_of_eight(frame / 50.0));
        stage.frame(1.0 / 50.0);
      }
      std::vector<std::uint64_t> bits;
      for (const Vec& tail : stage.tails)
        for (int i = 0; i < 3; ++i) bits.push_back(std::bit_cast<std::uint64_t>(tail[i]));
      for (std::size_t j = 0; j < character.skeleton.joint_count(); ++j)
        for (int i = 0; i < 4; ++i) bits.push_back(std::bit_cast<std::uint32_t>(stage.rotation(j)[i]));
      if (first.empty()) first = bits;
      EXPECT_EQ(bits, first) << test::simd_name(target);
    }
  }
}

}  // namespace
}  // namespace sinew
