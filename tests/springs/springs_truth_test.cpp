// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "tests/springs/spring_stage.h"
#include "tests/springs/spring_truth.h"
#include "tests/support/fixed_random.h"

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

/// A tree with swinging and carried joints, colliders of every kind and a group with a centre.
Character random_character(std::uint64_t seed, bool sheared) {
  test::FixedRandom random(seed);
  std::vector<std::uint32_t> parents{kNone, 0, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10};
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

/// Moves root and pose at random for two seconds, and compares at every tick.
void expect_job_is_the_truth(std::uint64_t seed, bool sheared, double tolerance_m) {
  const Character character = random_character(seed, sheared);
  SpringSettings settings;
  settings.sleep_rad_per_s = 0.0;
  SpringStage stage(character.skeleton, character.setup, settings);
  SpringTruth truth(character.skeleton, character.setup);
  test::FixedRandom random(seed + 1);
  for (int frame = 0; frame <= 120; ++frame) {
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
  for (std::uint64_t seed = 1; seed <= 20; ++seed) expect_job_is_the_truth(seed, false, 1e-9);
}

TEST(springs_truth, job_agrees_under_shear_and_mirroring) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) expect_job_is_the_truth(seed, true, 1e-9);
}

}  // namespace
}  // namespace sinew
