// SPDX-License-Identifier: MIT
// A job that runs a pose program: what it counts and what it refuses.
#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "runtime/model/mirror_scene.h"
#include "tests/pose_program/program_stage.h"
#include "tests/support/tiny_assets.h"

namespace sinew::test {
namespace {

using Stage = ProgramStage;

TEST(pose_program_job, work_is_counted_by_kind_and_what_is_not_in_the_program_counts_zero) {
  Stage stage(9);
  ASSERT_EQ(stage.run_program(PoseProgram().sample(0, 0.1).sample(1, 0.2).mean(2)), ErrorCode::ok);
  EXPECT_EQ(stage.work, (PoseProgramWork{.clips_sampled = 2, .poses_blended = 2}));
}

TEST(pose_program_job, every_kind_of_work_is_counted_and_added_to_the_count_before) {
  Stage stage(14);
  const MirrorMap map = make_mirror_map(stage.scene);
  const MirrorTables mirror = make_mirror_tables(map.joints);
  stage.assets.mirror = &mirror;
  stage.assets.mirrored_weight_source = map.weight_source;
  const PoseProgram program = PoseProgram()
                                  .sample(0, 0.1)
                                  .sample_mirrored(1, 0.2)
                                  .overlay()
                                  .sample(1, 0.3)
                                  .add_to_rest()
                                  .rest()
                                  .sample_mirrored(0, 0.4)
                                  .add()
                                  .override_joints(0)
                                  .external(0)
                                  .overlay_model();
  for (const std::uint32_t runs : {1u, 2u}) {
    ASSERT_EQ(stage.run_program(program), ErrorCode::ok);
    EXPECT_EQ(stage.work.clips_sampled, 4 * runs);
    EXPECT_EQ(stage.work.poses_mirrored, 2 * runs);
    EXPECT_EQ(stage.work.poses_overlaid, 2 * runs);
    EXPECT_EQ(stage.work.poses_added, 2 * runs);
    EXPECT_EQ(stage.work.joints_overridden, 2 * runs);
    EXPECT_EQ(stage.work.poses_blended, 0u);
  }
}

TEST(pose_program_job, clips_pages_and_tables_of_another_shape_are_refused) {
  Stage stage(16);
  const PoseProgram program = PoseProgram().sample(0, 0.1).sample(1, 0.2).overlay();
  const auto with_assets = [&](auto change) {
    Stage changed(16);
    change(changed.assets);
    return run(changed.job(program.ops()));
  };
  const Clip foreign = clip_of({}, chain_skeleton(static_cast<std::uint32_t>(stage.joints() + 1)));
  const Clip* const pages[] = {nullptr, &foreign, nullptr};
  PoseProgramJob job = stage.job(program.ops());
  job.inputs.pages = pages;
  EXPECT_EQ(run(job), ErrorCode::size_mismatch) << "the second page";
  const Clip clips[] = {stage.scene.clips[0], foreign};
  EXPECT_EQ(with_assets([](PoseProgramAssets&) {}), ErrorCode::ok);
  EXPECT_EQ(with_assets([&](PoseProgramAssets& a) { a.clips = clips; }), ErrorCode::size_mismatch);
  const std::vector<float> short_mask(stage.joints() - 1, 1.0f);
  const std::span<const float> masks[] = {stage.masks[0], short_mask};
  EXPECT_EQ(with_assets([&](PoseProgramAssets& a) { a.masks = masks; }), ErrorCode::size_mismatch);
  const std::vector<std::uint32_t> sources(stage.weights.size() + 1, 0);
  EXPECT_EQ(with_assets([&](PoseProgramAssets& a) { a.mirrored_weight_source = sources; }), ErrorCode::size_mismatch);
  const MirrorTables mirror = make_mirror_tables(std::vector<MirroredJoint>(stage.joints() + 1));
  EXPECT_EQ(with_assets([&](PoseProgramAssets& a) { a.mirror = &mirror; }), ErrorCode::size_mismatch);
}

TEST(pose_program_job, buffers_of_other_sizes_and_numbers_that_are_not_finite_are_refused) {
  Stage stage(10);
  PoseProgram program;
  program.sample(0, 0.1).external(0).overlay().override_joints(0);
  const auto code = [&](auto change) {
    PoseProgramJob job = stage.job(program.ops());
    change(job);
    return run(job);
  };
  EXPECT_EQ(code([](PoseProgramJob&) {}), ErrorCode::ok);
  EXPECT_EQ(code([](PoseProgramJob& job) { job.assets = nullptr; }), ErrorCode::size_mismatch);
  EXPECT_EQ(code([](PoseProgramJob& job) { job.memory = job.memory.first(64); }), ErrorCode::size_mismatch);
  EXPECT_EQ(code([](PoseProgramJob& job) { job.pose.joint_count -= 1; }), ErrorCode::size_mismatch);
  EXPECT_EQ(code([](PoseProgramJob& job) { job.pose.planes = nullptr; }), ErrorCode::size_mismatch);
  EXPECT_EQ(code([](PoseProgramJob& job) { job.weights = job.weights.first(1); }), ErrorCode::size_mismatch);
  EXPECT_EQ(code([](PoseProgramJob& job) { job.inputs.externals = {}; }), ErrorCode::index_out_of_range);
  const Clip* const one_page[] = {nullptr};
  EXPECT_EQ(code([&](PoseProgramJob& job) { job.inputs.pages = one_page; }), ErrorCode::size_mismatch);
  ExternalPose smaller = stage.external;
  smaller.weights = smaller.weights.first(1);
  EXPECT_EQ(code([&](PoseProgramJob& job) { job.inputs.externals = {&smaller, 1}; }), ErrorCode::size_mismatch);
  JointOverride bad{0, {}, OverrideSpace::local};
  bad.transform.rotation.y = std::numeric_limits<float>::infinity();
  const JointOverrides bad_joints{{&bad, 1}, 0};
  EXPECT_EQ(code([&](PoseProgramJob& job) { job.inputs.overrides = {&bad_joints, 1}; }), ErrorCode::not_finite);
  bad = {static_cast<std::uint32_t>(stage.joints()), {}, OverrideSpace::local};
  EXPECT_EQ(code([&](PoseProgramJob& job) { job.inputs.overrides = {&bad_joints, 1}; }), ErrorCode::index_out_of_range);
}

}  // namespace
}  // namespace sinew::test
