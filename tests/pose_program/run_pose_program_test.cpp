// SPDX-License-Identifier: MIT
#include "runtime/pose_program/run_pose_program.h"

#include <gtest/gtest.h>

#include <cstring>

#include "runtime/base/same_bits.h"
#include "runtime/math/axis_angle.h"
#include "runtime/pose/local_to_model.h"
#include "tests/pose_program/program_stage.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/fixed_random.h"
#include "tests/support/near.h"

namespace sinew::test {
namespace {

using Stage = ProgramStage;

/// Random operations. Each number is drawn in a statement of its own, so that all compilers draw the same program.
class RandomProgram {
 public:
  RandomProgram(std::uint64_t seed, const Scene& scene)
      : random_(seed), clips_(static_cast<std::uint32_t>(scene.clips.size())) {}

  /// The stack holds at most five poses. Operations that turn joints far from each other come last, since means of
  /// rotations that are half a turn apart have no one meaning.
  PoseProgram next() {
    program_.clear();
    depth_ = kept_ = 0;
    push();
    for (int i = 0; i < 12; ++i) add_operation();
    program_.mean(depth_);
    if (random_.below(2) == 0) {
      push();
      program_.overlay_model();
    }
    if (random_.below(2) == 0) {
      push_mirrored(1.0f);
      program_.overlay_model();
    }
    if (random_.below(2) == 0) {
      push_mirrored(random_.below(2) == 0 ? 0.1f : -0.1f);
      program_.push({.kind = PoseOpKind::rest_mirrored}).add();
    }
    if (random_.below(2) == 0) program_.override_joints(random_.below(3));
    return program_;
  }

 private:
  void push(float sign = 1.0f) {
    if (random_.below(8) == 0) {
      program_.rest();
      ++depth_;
      return;
    }
    const bool external = random_.below(5) == 0;
    const std::uint32_t clip = random_.below(clips_);
    const double time_s = random_.in(-0.2, 1.5);
    const auto weight = sign * static_cast<float>(random_.below(4) == 0 ? 1.0 : random_.unit());
    const std::uint8_t mask = random_mask();
    if (external)
      program_.external(0, weight, mask);
    else
      program_.sample(clip, time_s, weight, mask);
    ++depth_;
  }

  void push_mirrored(float scale) {
    const std::uint32_t clip = random_.below(clips_);
    const double time_s = random_.in(-0.2, 1.5);
    const auto weight = scale * static_cast<float>(random_.unit());
    program_.sample_mirrored(clip, time_s, weight, random_mask());
  }

  void add_operation() {
    const std::uint32_t kind = random_.below(9);
    if (kind < 3 || depth_ < 2) {
      if (depth_ < 5) push();
      return;
    }
    const auto weight = static_cast<float>(random_.unit());
    const std::uint8_t mask = random_mask();
    if (kind == 3) {
      const std::uint32_t count = 1 + random_.below(depth_);
      const double threshold = random_.below(2) == 0 ? 1.0 : 0.1;
      program_.mean(count, weight, threshold, mask);
      depth_ -= count - 1;
    } else if (kind == 4) {
      program_.overlay(weight, mask);
      --depth_;
    } else if (kind == 7) {
      if (kept_++ < kMostKept) program_.cached(weight, mask);
    } else if (kind == 8) {
      const double share = random_.unit();
      program_.procedure(0, share, weight);
    } else {
      add_difference(kind == 6, 0.1f * weight);
    }
  }

  /// Adds or subtracts a new pose, from the rest pose or from a reference.
  void add_difference(bool from_reference, float weight) {
    const auto frame = random_.below(2) == 0 ? DeltaFrame::parent : DeltaFrame::joint;
    push(random_.below(2) == 0 ? 1.0f : -1.0f);
    if (from_reference) push();
    from_reference ? program_.add(weight, frame) : program_.add_to_rest(weight, frame);
    depth_ -= from_reference ? 2 : 1;
  }

  std::uint8_t random_mask() {
    const bool masked = random_.below(3) == 0;
    const auto mask = static_cast<std::uint8_t>(random_.below(3));
    return masked ? mask : PoseOp::kNoMask;
  }

  FixedRandom random_;
  static constexpr std::uint32_t kMostKept = 4;
  std::uint32_t clips_, depth_ = 0, kept_ = 0;
  PoseProgram program_;
};

double difference(const Transform& a, const Transformd& b) {
  return std::max({test::distance(Vec3<double>(a.translation), b.translation),
                   test::angle_between(quat_cast<double>(a.rotation), b.rotation),
                   test::distance(Vec3<double>(a.scale), b.scale)});
}

TEST(run_pose_program, random_programs_agree_with_the_equations_of_their_operations) {
  double worst = 0.0;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    Stage stage(seed);
    stage.use_mirror();
    RandomProgram random(100 + seed, stage.scene);
    for (int i = 0; i < 60; ++i) {
      const PoseProgram program = random.next();
      ASSERT_EQ(stage.run_program(program), ErrorCode::ok);
      const reference::SlowPose slow = stage.run_slowly(program.ops());
      for (std::size_t j = 0; j < stage.joints(); ++j)
        worst = std::max(worst, difference(stage.result.span().get(j), slow.joints[j]));
      for (std::size_t w = 0; w < slow.weights.size(); ++w) EXPECT_NEAR(stage.weights[w], slow.weights[w], 2e-6);
      for (std::size_t p = 0; p < slow.properties.size(); ++p)
        EXPECT_NEAR(stage.properties[p], slow.properties[p], 2e-6 * (1.0 + std::fabs(slow.properties[p])));
    }
  }
  EXPECT_LT(worst, 2e-5);
}

TEST(run_pose_program, the_same_program_gives_the_same_bits_and_allocates_nothing) {
  Stage stage(3);
  stage.use_mirror();
  RandomProgram random(5, stage.scene);
  for (int i = 0; i < 20; ++i) {
    const PoseProgram program = random.next();
    ASSERT_EQ(stage.run_program(program), ErrorCode::ok);
    std::vector<Transform> first;
    for (std::size_t j = 0; j < stage.joints(); ++j) first.push_back(stage.result.span().get(j));
    std::memset(stage.block.get(), 0xEE, stage.bytes);
    const AllocationCounter allocations;
    ASSERT_EQ(stage.run_program(program), ErrorCode::ok);
    EXPECT_EQ(allocations.count(), 0u);
    for (std::size_t j = 0; j < stage.joints(); ++j) EXPECT_TRUE(same_bits(first[j], stage.result.span().get(j)));
  }
}

TEST(run_pose_program, a_full_overlay_has_the_bits_of_the_upper_pose_and_one_of_weight_0_those_of_the_lower) {
  Stage stage(4);
  const auto joint_bits = [&](const PoseProgram& program) {
    EXPECT_EQ(stage.run_program(program), ErrorCode::ok);
    std::vector<Transform> out;
    for (std::size_t j = 0; j < stage.joints(); ++j) out.push_back(stage.result.span().get(j));
    return out;
  };
  const std::vector<Transform> lower = joint_bits(PoseProgram().sample(0, 0.3));
  const std::vector<Transform> upper = joint_bits(PoseProgram().sample(1, 0.7));
  EXPECT_EQ(joint_bits(PoseProgram().sample(0, 0.3).sample(1, 0.7).overlay()), upper);
  EXPECT_EQ(joint_bits(PoseProgram().sample(0, 0.3).sample(1, 0.7, 0.0f).overlay()), lower);
  EXPECT_EQ(joint_bits(PoseProgram().sample(0, 0.3).sample(1, 0.7, 0.0f).overlay_model()), lower);
  const std::vector<Transform> masked = joint_bits(PoseProgram().sample(0, 0.3).sample(1, 0.7, 1.0f, 1).overlay());
  for (std::size_t j = 0; j < stage.joints(); ++j)
    EXPECT_EQ(masked[j], stage.mask_memory[1][j] == 1.0f ? upper[j] : lower[j]) << j;
}

// An upper body of weight 1 over a walk of weight 1 is the upper body, and no mean of both.
TEST(run_pose_program, a_mean_below_its_threshold_fills_with_the_rest_pose_and_above_it_normalises) {
  Stage stage(6);
  const auto x = [&](const PoseProgram& program) {
    EXPECT_EQ(stage.run_program(program), ErrorCode::ok);
    return static_cast<double>(stage.result.span().get(1).translation.x);
  };
  const double a = x(PoseProgram().external(0)), rest = static_cast<double>(stage.scene.skeleton.rest[1].translation.x);
  EXPECT_NEAR(x(PoseProgram().external(0, 0.25f).mean(1)), rest + 0.25 * (a - rest), 1e-6);
  EXPECT_NEAR(x(PoseProgram().external(0, 0.25f).mean(1, 1.0f, 0.1)), a, 1e-6);
  EXPECT_NEAR(x(PoseProgram().external(0, 0.05f).mean(1, 1.0f, 0.1)), rest + 0.5 * (a - rest), 1e-6);
  EXPECT_NEAR(x(PoseProgram().mean(0)), rest, 0.0);
}

TEST(run_pose_program, an_overlay_in_model_space_keeps_the_upper_rotations_whatever_the_joints_above_do) {
  Stage stage(7);
  const auto model_rotations = [&](const PoseProgram& program) {
    EXPECT_EQ(stage.run_program(program), ErrorCode::ok);
    std::vector<Quat<double>> model;
    for (std::size_t j = 0; j < stage.joints(); ++j) {
      const Quat<double> local = quat_cast<double>(stage.result.span().get(j).rotation);
      const std::uint32_t parent = stage.scene.skeleton.parents[j];
      model.push_back(parent == kNone ? local : model[parent] * local);
    }
    return model;
  };
  const auto upper = model_rotations(PoseProgram().sample(1, 0.7));
  const auto mixed = model_rotations(PoseProgram().sample(0, 0.3).sample(1, 0.7, 1.0f, 1).overlay_model());
  double moved = 0.0;
  for (std::size_t j = 0; j < stage.joints(); ++j) {
    if (stage.mask_memory[1][j] == 1.0f) {
      EXPECT_LT(test::angle_between(mixed[j], upper[j]), 1e-6);
    } else {
      moved = std::max(moved, test::angle_between(mixed[j], upper[j]));
    }
  }
  EXPECT_GT(moved, 0.05) << "joints outside of the mask follow the lower pose";
}

TEST(run_pose_program, joints_are_placed_in_model_space_under_any_parent_but_a_flat_one) {
  Stage stage(8);
  const auto joint = static_cast<std::uint32_t>(stage.joints() - 1);
  const std::uint32_t parent = stage.scene.skeleton.parents[joint];
  ASSERT_NE(parent, kNone);
  Transform above = stage.scene.skeleton.rest[parent];
  above.scale = {2, 2, 2};
  const Transform given{{0.5f, 1, -2}, quat_cast<float>(quat_from_axis_angle(Vec3<double>(1, 0, 0), 0.8)), {1, 1, 1}};
  const JointOverride joints[] = {{parent, above}, {joint, given, OverrideSpace::model}};
  stage.overrides[0] = {joints, 0};
  ASSERT_EQ(stage.run_program(PoseProgram().sample(0, 0.3).override_joints(0)), ErrorCode::ok);
  std::vector<Affine> model(stage.joints());
  ASSERT_EQ(run(LocalToModelJob{&stage.scene.skeleton, stage.result.span(), {}, model}), ErrorCode::ok);
  EXPECT_LT(test::distance(translation_of(model[joint]), given.translation), 2e-6);
  EXPECT_EQ(stage.result.span().get(parent), above) << "local transforms keep their bits";

  above.scale = {2, 0, 2};
  const JointOverride flat[] = {{parent, above}, {joint, given, OverrideSpace::model}};
  stage.overrides[0] = {flat, 0};
  ASSERT_EQ(stage.run_program(PoseProgram().sample(0, 0.3).override_joints(0)), ErrorCode::ok);
  const Transform stayed = stage.result.span().get(joint);
  ASSERT_EQ(stage.run_program(PoseProgram().sample(0, 0.3)), ErrorCode::ok);
  EXPECT_EQ(stayed, stage.result.span().get(joint));
}

/// Raises the first joint, and remembers what it was called with.
struct Raise {
  int calls = 0;
  float share = 0.0f;

  PoseProcedure procedure() { return {&Raise::run, this, 0}; }
  static void run(void* context, const ProcedurePose& pose) {
    Raise& self = *static_cast<Raise*>(context);
    ++self.calls;
    self.share = pose.share;
    pose.local.plane(PoseSpan::ty)[0] += pose.share;
  }
};

TEST(run_pose_program, a_procedure_changes_the_topmost_pose_and_without_a_share_it_does_not_run) {
  Stage stage(11);
  Raise raise;
  stage.procedures = {raise.procedure()};
  ASSERT_EQ(stage.run_program(PoseProgram().sample(0, 0.3)), ErrorCode::ok);
  const float low = stage.result.span().get(0).translation.y;
  ASSERT_EQ(stage.run_program(PoseProgram().sample(0, 0.3).procedure(0, 0.5)), ErrorCode::ok);
  EXPECT_EQ(stage.result.span().get(0).translation.y, low + 0.5f);
  ASSERT_EQ(stage.run_program(PoseProgram().sample(0, 0.3).procedure(0, 0.0)), ErrorCode::ok);
  EXPECT_EQ(raise.calls, 1);
  EXPECT_EQ(raise.share, 0.5f);
  stage.procedures[0].run = nullptr;
  EXPECT_EQ(stage.run_program(PoseProgram().sample(0, 0.3).procedure(0)), ErrorCode::unsupported);
}

// A caller looks at the pose in the middle, so both halves together give the bits of the whole.
TEST(run_pose_program, a_program_that_runs_in_two_parts_gives_the_bits_of_the_whole) {
  Stage stage(12);
  stage.use_mirror();
  RandomProgram random(17, stage.scene);
  for (int i = 0; i < 20; ++i) {
    const PoseProgram program = random.next();
    ASSERT_EQ(stage.run_program(program), ErrorCode::ok);
    std::vector<Transform> whole;
    for (std::size_t j = 0; j < stage.joints(); ++j) whole.push_back(stage.result.span().get(j));
    const std::vector<float> weights = stage.weights, properties = stage.properties;
    PoseProgramJob first = stage.job(program.ops()), second = first;
    first.end = second.first = 1 + static_cast<std::size_t>(i) % program.ops().size();
    ASSERT_EQ(run(first), ErrorCode::ok);
    ASSERT_EQ(run(second), ErrorCode::ok);
    for (std::size_t j = 0; j < stage.joints(); ++j) EXPECT_TRUE(same_bits(whole[j], stage.result.span().get(j)));
    EXPECT_EQ(stage.weights, weights);
    EXPECT_EQ(stage.properties, properties);
  }
}

TEST(run_pose_program, masks_of_the_caller_follow_those_of_the_tables) {
  Stage stage(13);
  const auto pose = [&](const PoseProgram& program, std::span<const PoseMask> masks) {
    PoseProgramJob job = stage.job(program.ops());
    job.inputs.masks = masks;
    EXPECT_EQ(run(job), ErrorCode::ok);
    std::vector<Transform> out;
    for (std::size_t j = 0; j < stage.joints(); ++j) out.push_back(stage.result.span().get(j));
    return out;
  };
  const PoseProgram by_table = PoseProgram().sample(0, 0.3).sample(1, 0.7, 1.0f, 0).overlay();
  const PoseProgram by_caller = PoseProgram().sample(0, 0.3).sample(1, 0.7, 1.0f, 2).overlay();
  const PoseMask mask{.joints = stage.mask_memory[0], .version = 1};
  EXPECT_EQ(pose(by_table, {}), pose(by_caller, {&mask, 1}));
  std::vector<float> negative = stage.mask_memory[0];
  negative[1] = -0.1f;
  const PoseMask bad{.joints = negative, .version = 1};
  PoseProgramJob job = stage.job(by_caller.ops());
  job.inputs.masks = {&bad, 1};
  EXPECT_EQ(run(job), ErrorCode::negative_weight);
  job.inputs.masks = {};
  EXPECT_EQ(run(job), ErrorCode::index_out_of_range);
}

TEST(run_pose_program, each_external_pose_has_its_own_joints_weights_and_properties) {
  Stage stage(11);
  ASSERT_FALSE(stage.weights.empty());
  ASSERT_FALSE(stage.properties.empty());
  PoseMemory second(stage.joints());
  for (std::size_t j = 0; j < stage.joints(); ++j) second.span().set(j, {glm::vec3(static_cast<float>(j))});
  const std::vector<float> weights(stage.weights.size(), 0.75f), properties(stage.properties.size(), 3.0f);
  const ExternalPose both[] = {stage.external, {second.span(), weights, properties, 0}};
  const PoseProgram program = PoseProgram().external(1);
  PoseProgramJob job = stage.job(program.ops());
  job.inputs.externals = both;
  ASSERT_EQ(run(job), ErrorCode::ok);
  EXPECT_EQ(stage.result.span().get(2).translation, glm::vec3(2.0f));
  EXPECT_EQ(stage.weights, weights);
  EXPECT_EQ(stage.properties, properties);
  ExternalPose fewer = both[1];
  fewer.properties = fewer.properties.first(fewer.properties.size() - 1);
  const ExternalPose bad[] = {both[0], fewer};
  job.inputs.externals = bad;
  EXPECT_EQ(run(job), ErrorCode::size_mismatch) << "of the second pose too";
}

TEST(run_pose_program, an_override_of_a_share_mixes_both_transforms) {
  Stage stage(12);
  const Transform given{{1, 2, 3}, stage.scene.skeleton.rest[0].rotation, {2, 2, 2}};
  const JointOverride joints[] = {{0, given}};
  const JointOverrides lists[] = {{}, {joints, 0}};
  const auto placed = [&](double share, float weight) {
    const PoseProgram program = PoseProgram().rest().override_joints(1, share, weight);
    PoseProgramJob job = stage.job(program.ops());
    job.inputs.overrides = lists;
    EXPECT_EQ(run(job), ErrorCode::ok);
    return stage.result.span().get(0);
  };
  const Transform rest = stage.scene.skeleton.rest[0];
  for (const double share : {0.0, 0.25, 1.0}) {
    const auto w = static_cast<float>(share);
    const Transform found = placed(share, 0.5f);
    EXPECT_LT(test::distance(found.translation, rest.translation * (1.0f - w) + given.translation * w), 1e-6) << share;
    EXPECT_LT(test::distance(found.scale, rest.scale * (1.0f - w) + given.scale * w), 1e-6) << share;
  }
}

/// Base, layer and reference lie one above the other: 1 + w (3 - 2) along x, and the other way round for y.
TEST(run_pose_program, an_addition_takes_base_layer_and_reference_in_this_order) {
  Stage stage(15);
  std::vector<PoseMemory> poses;
  std::vector<std::vector<float>> weights;
  std::vector<ExternalPose> externals;
  for (const float number : {1.0f, 3.0f, 2.0f}) {
    poses.emplace_back(stage.joints());
    weights.emplace_back(stage.weights.size(), number);
  }
  const glm::vec3 places[] = {{1, 1, 0}, {3, 2, 0}, {2, 4, 0}};
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < stage.joints(); ++j) poses[i].span().set(j, {places[i]});
    externals.push_back({poses[i].span(), weights[i], {}, 0});
  }
  const PoseProgram program = PoseProgram().external(0).external(1, 0.5f).external(2).add();
  PoseProgramJob job = stage.job(program.ops());
  job.inputs.externals = externals;
  ASSERT_EQ(run(job), ErrorCode::ok);
  EXPECT_LT(test::distance(stage.result.span().get(1).translation, glm::vec3(1.5f, 0.0f, 0.0f)), 1e-6);
  EXPECT_EQ(stage.weights, std::vector<float>(stage.weights.size(), 1.5f));
}

/// A base turned about x, and a layer that turns about z: in the joint's frame that z is turned along.
TEST(run_pose_program, an_addition_in_the_joints_frame_turns_about_the_joints_own_axes) {
  Stage stage(16);
  const auto about = [](const glm::vec3& axis) {
    return quat_cast<float>(quat_from_axis_angle(Vec3<double>(axis), 1.2));
  };
  const Quat<float> base = about({1, 0, 0}), layer = about({0, 0, 1});
  std::vector<PoseMemory> poses;
  std::vector<ExternalPose> externals;
  for (const Quat<float>& q : {base, layer, quat_identity<float>()}) {
    poses.emplace_back(stage.joints());
    for (std::size_t j = 0; j < stage.joints(); ++j) poses.back().span().set(j, {.rotation = q});
    externals.push_back({poses.back().span(), stage.weights, {}, 0});
  }
  for (const bool in_joint : {false, true}) {
    const PoseProgram program =
        PoseProgram().external(0).external(1).external(2).add(1.0f, in_joint ? DeltaFrame::joint : DeltaFrame::parent);
    PoseProgramJob job = stage.job(program.ops());
    job.inputs.externals = externals;
    ASSERT_EQ(run(job), ErrorCode::ok);
    const Quat<float> expected = in_joint ? base * layer : layer * base;
    EXPECT_NEAR(std::abs(quat_dot(stage.result.span().get(1).rotation, expected)), 1.0f, 1e-6f) << in_joint;
  }
}

}  // namespace
}  // namespace sinew::test
