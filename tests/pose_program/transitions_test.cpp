// SPDX-License-Identifier: MIT
// Transitions in pose programs: no jump in pose or velocity, for any phase, also where one interrupts another.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "runtime/base/same_bits.h"
#include "runtime/math/axis_angle.h"
#include "runtime/math/quat_log_exp.h"
#include "tests/pose_program/program_stage.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/near.h"

namespace sinew::test {
namespace {

constexpr double kDuration_s = 0.3, kStep_s = 1e-4;
constexpr std::uint32_t kSteps = 3000;

PoseOp transition(PoseOpKind kind, double progress) { return {progress, 1.0f, kSteps, PoseOp::kNoMask, kind}; }
constexpr PoseOpKind kKinds[] = {PoseOpKind::inertialize, PoseOpKind::dead_blend};

/// Smooth motions: every joint swings about an axis of its own and sways. All are poses of the caller.
class Motions {
 public:
  explicit Motions(std::uint64_t seed) : stage_(seed) {
    FixedRandom random(seed + 7);
    for (std::size_t m = 0; m < kMotions; ++m)
      for (std::size_t j = 0; j < stage_.joints(); ++j) {
        const Vec3<double> axis = random.direction<double>();
        const double phase = random.in(0.0, 6.0), speed = random.in(3.0, 9.0);
        swings_[m].push_back({axis, phase, speed});
      }
  }

  /// Adds a pose of a motion; answers its index.
  std::uint32_t pose(std::size_t motion, double time_s) {
    PoseMemory& memory = poses_.emplace_back(stage_.joints());
    for (std::size_t j = 0; j < stage_.joints(); ++j) {
      const Swing& swing = swings_[motion][j];
      const double angle = 0.6 * std::sin(swing.speed * time_s + swing.phase);
      memory.span().set(j, {glm::vec3(swing.axis * (angle + double(motion))),
                            quat_cast<float>(quat_from_axis_angle(swing.axis, angle)), glm::vec3(1.0f)});
    }
    return static_cast<std::uint32_t>(poses_.size() - 1);
  }

  std::vector<Transformd> run(const PoseProgram& program) {
    std::vector<ExternalPose> externals;
    for (PoseMemory& memory : poses_) externals.push_back({memory.span(), stage_.external_weights, {}, 0});
    PoseProgramJob job = stage_.job(program.ops());
    job.inputs.externals = externals;
    EXPECT_EQ(sinew::run(job), ErrorCode::ok);
    std::vector<Transformd> pose;
    for (std::size_t j = 0; j < stage_.joints(); ++j) pose.push_back(in_double(stage_.result.span().get(j)));
    return pose;
  }
  void clear() { poses_.clear(); }

 private:
  struct Swing {
    Vec3<double> axis;
    double phase, speed;
  };
  static constexpr std::size_t kMotions = 3;

  ProgramStage stage_;
  std::array<std::vector<Swing>, kMotions> swings_;
  std::vector<PoseMemory> poses_;
};

/// One transition from one motion to another, which starts at `start_s`.
struct Change {
  PoseOpKind kind;
  std::size_t from, to;
  double start_s;
};

/// The pose at a time. Changes that began later come first in the program: the older ones work on what they leave.
std::vector<Transformd> pose_at(Motions& motions, double time_s, std::span<const Change> changes) {
  motions.clear();
  PoseProgram program;
  program.external(motions.pose(changes.back().to, time_s));
  for (std::size_t c = changes.size(); c-- > 0;) {
    const Change& change = changes[c];
    program.external(motions.pose(change.from, change.start_s));
    program.external(motions.pose(change.from, change.start_s - kStep_s));
    if (change.kind == PoseOpKind::inertialize) {
      program.external(motions.pose(change.to, change.start_s));
      program.external(motions.pose(change.to, change.start_s - kStep_s));
    }
    program.push(transition(change.kind, std::min(1.0, (time_s - change.start_s) / kDuration_s)));
  }
  return motions.run(program);
}

using Poses = std::array<std::vector<Transformd>, 3>;  // at equal steps

/// Velocities of the first of three poses, to the second order: angular and linear ones of each joint.
std::vector<Vec3<double>> velocities(const Poses& poses, double step_s) {
  std::vector<Vec3<double>> found;
  for (std::size_t j = 0; j < poses[0].size(); ++j) {
    const auto turn = [&](std::size_t p) {
      Quat<double> q = poses[p][j].rotation * quat_conjugate(poses[0][j].rotation);
      return quat_log(q.w < 0.0 ? q * -1.0 : q) * 2.0;
    };
    const auto way = [&](std::size_t p) { return poses[p][j].translation - poses[0][j].translation; };
    found.push_back((turn(1) * 4.0 - turn(2)) / (2.0 * step_s));
    found.push_back((way(1) * 4.0 - way(2)) / (2.0 * step_s));
  }
  return found;
}

struct Jump {
  double pose = 0.0, velocity = 0.0, largest_velocity = 0.0;
};

/// The jump where the last of the changes begins.
Jump jump_at_start(Motions& motions, std::span<const Change> changes) {
  constexpr double kStep = 2e-4;
  const double start_s = changes.back().start_s;
  const auto before = changes.first(changes.size() - 1);
  const auto old_pose = [&](double time_s) {
    if (!before.empty()) return pose_at(motions, time_s, before);
    motions.clear();
    return motions.run(PoseProgram().external(motions.pose(changes.back().from, time_s)));
  };
  const Poses left{old_pose(start_s), old_pose(start_s - kStep), old_pose(start_s - 2 * kStep)};
  const Poses right{pose_at(motions, start_s, changes), pose_at(motions, start_s + kStep, changes),
                    pose_at(motions, start_s + 2 * kStep, changes)};
  Jump jump;
  for (std::size_t j = 0; j < left[0].size(); ++j)
    jump.pose = std::max({jump.pose, angle_between(left[0][j].rotation, right[0][j].rotation),
                          distance(left[0][j].translation, right[0][j].translation)});
  const std::vector<Vec3<double>> from = velocities(left, -kStep), to = velocities(right, kStep);
  for (std::size_t v = 0; v < from.size(); ++v) {
    jump.velocity = std::max(jump.velocity, distance(from[v], to[v]));
    jump.largest_velocity = std::max({jump.largest_velocity, length(from[v]), length(to[v])});
  }
  return jump;
}

TEST(transitions, begin_without_a_jump_in_pose_or_velocity_at_240_phases) {
  for (const PoseOpKind kind : kKinds) {
    Motions motions(3);
    for (int phase = 0; phase < 240; ++phase) {
      const Change change{kind, 0, 1, 1.0 + phase / 240.0};
      const Jump jump = jump_at_start(motions, {&change, 1});
      EXPECT_LT(jump.pose, 1e-5) << phase;
      EXPECT_LT(jump.velocity, 0.01 * jump.largest_velocity) << name_of(kind) << " " << phase;
    }
  }
}

TEST(transitions, interrupt_each_other_without_a_jump) {
  Motions motions(4);
  for (int i = 0; i < 64; ++i) {
    const auto kind = [&](int bit) { return kKinds[(i >> bit) % 2]; };
    const double start_s = 1.0 + i * 0.017;
    const Change changes[] = {
        {kind(0), 0, 1, start_s}, {kind(1), 1, 2, start_s + 0.05}, {kind(2), 2, 0, start_s + 0.1 + 0.01 * (i % 7)}};
    const Jump jump = jump_at_start(motions, changes);
    EXPECT_LT(jump.pose, 1e-5) << i;
    EXPECT_LT(jump.velocity, 0.01 * jump.largest_velocity) << i;
  }
}

/// The place of the first joint while the source moves along x and the target rests at 0.
float place_of(ProgramStage& stage, double x, double velocity_per_duration, double progress) {
  PoseMemory source(stage.joints()), before(stage.joints()), target(stage.joints());
  constexpr std::uint16_t kFewSteps = 100;
  for (std::size_t j = 0; j < stage.joints(); ++j) {
    source.span().set(j, {glm::vec3(static_cast<float>(x), 0, 0)});
    before.span().set(j, {glm::vec3(static_cast<float>(x - velocity_per_duration / kFewSteps), 0, 0)});
    target.span().set(j, Transform{});
  }
  std::vector<ExternalPose> externals;
  for (PoseMemory* memory : {&source, &before, &target})
    externals.push_back({memory->span(), stage.external_weights, {}, 0});
  PoseProgramJob job{};
  const PoseProgram program =
      PoseProgram().external(2).external(0).external(1).external(2).external(2).inertialize(progress, kFewSteps);
  job = stage.job(program.ops());
  job.inputs.externals = externals;
  EXPECT_EQ(run(job), ErrorCode::ok);
  return stage.result.span().get(0).translation.x;
}

TEST(transitions, inertialization_reaches_the_target_without_crossing_it) {
  ProgramStage stage(5);
  for (const double velocity : {-60.0, -20.0, -5.0, -1.0, 0.0, 4.0}) {
    float last = place_of(stage, 1.0, velocity, 0.0);
    EXPECT_NEAR(last, 1.0f, 1e-6f);
    for (int i = 1; i <= 200; ++i) {
      const float place = place_of(stage, 1.0, velocity, i / 200.0);
      EXPECT_GE(place, -1e-7f) << velocity;
      EXPECT_TRUE(velocity > 0.0 || place <= last + 1e-7f) << velocity << " moves on towards the target";
      last = place;
    }
    EXPECT_EQ(last, 0.0f);
  }
}

TEST(transitions, rotations_that_would_grow_over_half_a_turn_lose_their_velocity) {
  for (const double speed : {1.0, 40.0}) {  // radians per duration, outwards
    ProgramStage stage(6);
    const auto turned = [](double angle) {
      return Transform{.rotation = quat_cast<float>(quat_from_axis_angle(Vec3<double>(0, 0, 1), angle))};
    };
    std::array<PoseMemory, 3> poses{PoseMemory(stage.joints()), PoseMemory(stage.joints()), PoseMemory(stage.joints())};
    for (std::size_t j = 0; j < stage.joints(); ++j) {
      poses[0].span().set(j, turned(2.5));
      poses[1].span().set(j, turned(2.5 - speed / 1000.0));
      poses[2].span().set(j, {});
    }
    std::vector<ExternalPose> externals;
    for (PoseMemory& memory : poses) externals.push_back({memory.span(), stage.external_weights, {}, 0});
    double largest = 0.0;
    for (int i = 0; i <= 100; ++i) {
      const PoseProgram program =
          PoseProgram().external(2).external(0).external(1).external(2).external(2).inertialize(i / 100.0, 1000);
      PoseProgramJob job = stage.job(program.ops());
      job.inputs.externals = externals;
      ASSERT_EQ(run(job), ErrorCode::ok);
      largest = std::max(largest, angle_between(stage.result.span().get(0).rotation, quat_identity<double>()));
    }
    EXPECT_LT(largest, speed > 10.0 ? 2.5 + 1e-5 : 3.0);
  }
}

TEST(transitions, that_are_over_keep_the_bits_of_the_target) {
  ProgramStage stage(7);
  ASSERT_EQ(stage.run_program(PoseProgram().sample(0, 0.4)), ErrorCode::ok);
  std::vector<Transform> target;
  for (std::size_t j = 0; j < stage.joints(); ++j) target.push_back(stage.result.span().get(j));
  for (const PoseOpKind kind : kKinds) {
    PoseProgram program = PoseProgram().sample(0, 0.4).sample(1, 0.2).sample(1, 0.1);
    if (kind == PoseOpKind::inertialize) program.sample(0, 0.2).sample(0, 0.1);
    program.push(transition(kind, 1.0));
    ASSERT_EQ(stage.run_program(program), ErrorCode::ok);
    for (std::size_t j = 0; j < stage.joints(); ++j) EXPECT_TRUE(same_bits(target[j], stage.result.span().get(j))) << j;
  }
}

/// One of random form, whose operands may be transitions too.
void add_random(FixedRandom& random, PoseProgram& program, int depth) {
  const auto sample = [&](std::uint32_t clip, double time_s) { program.sample(clip, time_s); };
  if (depth == 0) {
    const std::uint32_t clip = random.below(2);
    return sample(clip, random.unit());
  }
  add_random(random, program, depth - 1);
  const bool inertializes = random.below(2) == 0;
  const std::uint32_t source = random.below(2), steps = 1 + random.below(8);
  const double source_s = random.in(0.1, 0.9), target_s = random.in(0.1, 0.9), step_s = random.in(0.01, 0.05);
  sample(source, source_s);
  sample(source, source_s - step_s);
  if (inertializes) {
    sample(1 - source, target_s);
    sample(1 - source, target_s - step_s);
  }
  const double progress = random.unit();
  inertializes ? program.inertialize(progress, steps) : program.dead_blend(progress, steps);
  if (random.below(3) == 0) program.cached();
}

TEST(transitions, random_ones_agree_with_their_equations_and_allocate_nothing) {
  double worst = 0.0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    ProgramStage stage(seed);
    FixedRandom random(seed + 200);
    for (int i = 0; i < 40; ++i) {
      PoseProgram program;
      add_random(random, program, 1 + i % 3);
      const AllocationCounter allocations;
      ASSERT_EQ(stage.run_program(program), ErrorCode::ok);
      EXPECT_EQ(allocations.count(), 0u);
      const reference::SlowPose slow = stage.run_slowly(program.ops());
      for (std::size_t j = 0; j < stage.joints(); ++j) {
        const Transform fast = stage.result.span().get(j);
        worst = std::max({worst, angle_between(fast.rotation, slow.joints[j].rotation),
                          distance(Vec3<double>(fast.translation), slow.joints[j].translation),
                          distance(Vec3<double>(fast.scale), slow.joints[j].scale)});
      }
      for (std::size_t w = 0; w < slow.weights.size(); ++w) EXPECT_NEAR(stage.weights[w], slow.weights[w], 2e-5);
      for (std::size_t p = 0; p < slow.properties.size(); ++p)
        EXPECT_NEAR(stage.properties[p], slow.properties[p], 2e-5 * (1.0 + std::fabs(slow.properties[p])));
    }
  }
  EXPECT_LT(worst, 1e-4);
}

TEST(transitions, work_counts_starts_and_poses) {
  ProgramStage stage(9);
  const PoseProgram program = PoseProgram().sample(0, 0.1).sample(1, 0.2).sample(1, 0.1).dead_blend(0.5, 10).cached();
  ASSERT_EQ(stage.run_program(program), ErrorCode::ok);
  EXPECT_EQ(stage.work, (PoseProgramWork{.clips_sampled = 3, .transitions_started = 1, .poses_in_transition = 1}));
}

}  // namespace
}  // namespace sinew::test
