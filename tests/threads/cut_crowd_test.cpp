// SPDX-License-Identifier: MIT
// Frames of a job thread that stop at a cut: the caller changes poses in the middle of the frame.
#include <gtest/gtest.h>

#include <atomic>
#include <limits>
#include <map>
#include <optional>
#include <thread>
#include <vector>

#include "runtime/plan/cut_frame.h"
#include "tests/plan/frame_equality.h"
#include "tests/scenes/random_scene.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/fixed_random.h"
#include "tests/threads/crowd.h"
#include "tests/threads/thread_executor.h"

namespace sinew::test {
namespace {

using Id = JobThread::Character;
using Changed = JobThread::CharacterInput;

/// Characters of one scene whose plans allow cuts and programs.
class CutCrowd {
 public:
  explicit CutCrowd(std::size_t count) : programs_(count), scene_(random_scene(5)) {
    Needs needs;
    needs.in.cut = true;
    needs.in.program = {.ops = 4, .slots = 2};
    plan_ = compile_plan(lend(scene_), needs);
    needs.in.cut = false;
    uncut_ = compile_plan(lend(scene_), needs);
  }

  const Plan& plan() const { return plan_; }
  const Plan& uncut() const { return uncut_; }
  /// in   number  other numbers give other poses
  FrameInput input(std::size_t c, std::uint64_t number) {
    programs_[c].clear();
    programs_[c].sample(0, 0.01 * static_cast<double>(number % 90) + 0.001 * static_cast<double>(c), 0.5f);
    programs_[c].sample(1, 0.02 * static_cast<double>(number % 40)).mean(2);
    FrameInput input{.program = programs_[c].ops()};
    input.root.row[0].w = static_cast<float>(c);
    input.root.row[1].w = 0.01f * static_cast<float>(number);
    return input;
  }

 private:
  std::vector<PoseProgram> programs_;
  Scene scene_;
  Plan plan_, uncut_;
};

/// The physics of these tests: lifts the last joint, by another height in each frame.
void push(const PoseSpan& pose, std::uint64_t number) {
  pose.plane(PoseSpan::ty)[pose.joint_count - 1] += 0.125f * static_cast<float>(number % 7);
}

JobThreadOptions polled_cuts(std::uint8_t buffers = 3) {
  JobThreadOptions options = spread();
  options.own_thread = false;
  options.frame_buffers = buffers;
  return options;
}

TEST(cut_crowd, results_are_those_of_the_changed_pose_and_nobody_sees_half_a_frame) {
  CutCrowd crowd(2);
  for (const bool own_thread : {true, false}) {
    JobThread jobs(own_thread ? spread() : polled_cuts());
    const Id cut = jobs.add_character(crowd.plan()), whole = jobs.add_character(crowd.uncut());
    FrameBuffer alone(crowd.plan()), beside(crowd.uncut());
    for (std::uint64_t n = 1; n <= 9; ++n) {
      const FrameInput inputs[] = {crowd.input(0, n), crowd.input(1, n)};
      const std::vector<Changed> changed{{cut, inputs[0], n % 2 == 0 ? 2 : kMostPoseOps}, {whole, inputs[1], 0}};
      const Result<Ticket> ticket = jobs.submit(changed);
      ASSERT_TRUE(ticket);
      ASSERT_FALSE(jobs.wait(*ticket));
      EXPECT_FALSE(jobs.done(*ticket));
      EXPECT_EQ(jobs.cut_pose(whole), nullptr) << "it does not stop";
      CutPose pose;
      ASSERT_EQ(run_to_cut(crowd.plan(), inputs[0], alone, pose, changed[0].ops_before_cut), ErrorCode::ok);
      const CutPose* const theirs = jobs.cut_pose(cut);
      ASSERT_NE(theirs, nullptr);
      EXPECT_TRUE(same_bits<Affine>(theirs->model, pose.model));
      for (const Id id : {cut, whole}) {
        const FrameResult* before = jobs.latest(id);
        EXPECT_EQ(before != nullptr ? before->frame : 0, n - 1);
      }
      push(pose.local, n);
      push(theirs->local, n);
      EXPECT_EQ(jobs.resume(), ErrorCode::ok);
      ASSERT_TRUE(jobs.wait(*ticket));
      EXPECT_EQ(jobs.resume(), ErrorCode::no_cut);
      EXPECT_EQ(jobs.cut_pose(cut), nullptr);
      ASSERT_EQ(jobs.last_error(), ErrorCode::ok);
      ASSERT_EQ(run_from_cut(crowd.plan(), inputs[0], alone), ErrorCode::ok);
      ASSERT_EQ(run_plan(crowd.uncut(), inputs[1], beside), ErrorCode::ok);
      EXPECT_EQ(first_difference(*jobs.latest(cut), alone.result()), "");
      EXPECT_EQ(first_difference(*jobs.latest(whole), beside.result()), "");
      EXPECT_EQ(jobs.latest(cut)->frame, n);
    }
  }
}

TEST(cut_crowd, kept_inputs_stop_again_and_vertices_that_stay_are_not_deformed_again) {
  CutCrowd crowd(2);
  JobThread jobs(polled_cuts());
  const Id cut = jobs.add_character(crowd.plan()), whole = jobs.add_character(crowd.plan());
  jobs.wait(*jobs.submit(std::vector<Changed>{{cut, crowd.input(0, 1), 1}, {whole, crowd.input(1, 1), 0}}));
  ASSERT_EQ(jobs.resume(), ErrorCode::ok);
  jobs.wait(1);
  const std::uint64_t since = jobs.latest(cut)->primitives[0].since_frame;
  for (Ticket n = 2; n <= 6; ++n) {
    ASSERT_FALSE(jobs.wait(*jobs.submit(std::span<const Changed>{})));
    ASSERT_NE(jobs.cut_pose(cut), nullptr);
    ASSERT_EQ(jobs.resume(), ErrorCode::ok);
    ASSERT_TRUE(jobs.wait(n));
    EXPECT_EQ(jobs.latest(cut)->frame, n);
    EXPECT_EQ(jobs.latest(cut)->work.vertices_skinned_linear == 0, n > 3) << "each of three buffers has them once";
    EXPECT_EQ(jobs.latest(cut)->primitives[0].since_frame, since);
    EXPECT_EQ(jobs.latest(whole)->frame, 1u) << "its input stays";
  }
  FrameInput asleep = crowd.input(0, 2);
  asleep.asleep = true;
  EXPECT_TRUE(jobs.wait(*jobs.submit(std::vector<Changed>{{cut, asleep, 1}}))) << "nobody stops";
}

TEST(cut_crowd, misuse_is_refused) {
  CutCrowd crowd(2);
  JobThread jobs(polled_cuts());
  const Id cut = jobs.add_character(crowd.plan()), whole = jobs.add_character(crowd.uncut());
  EXPECT_EQ(jobs.resume(), ErrorCode::no_cut);
  EXPECT_EQ(jobs.submit(std::vector<Changed>{{whole, crowd.input(1, 1), 1}}).error(), ErrorCode::not_in_needs);
  ASSERT_FALSE(jobs.wait(*jobs.submit(std::vector<Changed>{{cut, crowd.input(0, 1), 1}})));
  EXPECT_FALSE(jobs.poll()) << "the frame waits for the caller";
  EXPECT_FALSE(jobs.take_task());
  ASSERT_TRUE(jobs.submit(std::vector<Changed>{{cut, crowd.input(0, 2), 1}}));
  EXPECT_FALSE(jobs.wait(2)) << "the frame before waits at its cut";
  EXPECT_EQ(jobs.submit(std::span<const Changed>{}).error(), ErrorCode::busy);
  jobs.cut_pose(cut)->local.plane(PoseSpan::rx)[0] = std::numeric_limits<float>::quiet_NaN();
  ASSERT_EQ(jobs.resume(), ErrorCode::ok);
  ASSERT_FALSE(jobs.wait(2)) << "now the second frame waits";
  EXPECT_TRUE(jobs.done(1));
  EXPECT_EQ(jobs.last_error(), ErrorCode::not_finite);
  EXPECT_EQ(jobs.latest(cut), nullptr) << "no frame was good";
  ASSERT_EQ(jobs.resume(), ErrorCode::ok);
  ASSERT_TRUE(jobs.wait(2));
  EXPECT_EQ(jobs.last_error(), ErrorCode::ok);
  EXPECT_EQ(jobs.latest(cut)->frame, 2u);
  ASSERT_FALSE(jobs.wait(*jobs.submit(std::span<const Changed>{})));
  ASSERT_EQ(jobs.replace_plan(cut, crowd.uncut()), ErrorCode::ok);
  EXPECT_EQ(jobs.cut_pose(cut), nullptr) << "the new plan has not run";
  ASSERT_EQ(jobs.remove_character(cut), ErrorCode::ok);
  EXPECT_EQ(jobs.cut_pose(cut), nullptr);
  // The destructor drops the frame at its cut.
}

TEST(cut_crowd, a_job_thread_with_a_frame_at_its_cut_is_destroyed_without_waiting) {
  CutCrowd crowd(1);
  JobThread jobs(spread());
  const Id cut = jobs.add_character(crowd.plan());
  ASSERT_FALSE(jobs.wait(*jobs.submit(std::vector<Changed>{{cut, crowd.input(0, 1), 1}})));
}

TEST(cut_crowd, frames_with_a_cut_allocate_nothing) {
  CutCrowd crowd(3);
  JobThread jobs(polled_cuts());
  std::vector<Changed> changed;
  for (std::size_t c = 0; c < 3; ++c) changed.push_back({jobs.add_character(crowd.plan()), {}, kMostPoseOps});
  for (std::uint64_t n = 1; n <= 4; ++n) {
    for (std::size_t c = 0; c < 3; ++c) changed[c].input = crowd.input(c, n);
    const AllocationCounter allocations;
    const Ticket ticket = *jobs.submit(changed);
    while (!jobs.wait(ticket)) {
      for (const Changed& one : changed) push(jobs.cut_pose(one.character)->local, n);
      ASSERT_EQ(jobs.resume(), ErrorCode::ok);
    }
    for (const Changed& one : changed) ASSERT_EQ(jobs.latest(one.character)->frame, n);
    EXPECT_EQ(allocations.count(), 0u);
  }
}

/// Characters that stop or not and follow each other at random, changed at the cut. All results are those of one run
/// after the other, leaders first, each with the final joint of its leader.
void drive_cuts(std::uint64_t seed, JobThreadOptions options) {
  constexpr std::size_t kCount = 7;
  CutCrowd crowd(kCount);
  JobThread jobs(std::move(options));
  FixedRandom random(seed);
  struct Model {
    std::uint64_t input = 0;  // 0 = none yet
    std::size_t ops_before_cut = 0;
    bool asleep = false;
    std::optional<std::size_t> leader;
    std::vector<Affine> joints;  // of the newest frame; empty if it has none
  };
  std::vector<Model> model(kCount);
  for (std::size_t c = 0; c < kCount; ++c) ASSERT_EQ(jobs.add_character(crowd.plan()), c);
  const auto any = [&] { return static_cast<std::size_t>(random.below(kCount)); };
  for (std::uint64_t n = 1; n < 60; ++n) {
    if (const std::size_t c = any(); random.below(3) == 0) {
      ASSERT_EQ(jobs.stop_following(static_cast<Id>(c)), ErrorCode::ok);
      model[c].leader.reset();
    }
    if (const std::size_t a = any(), b = any(); jobs.follow(static_cast<Id>(a), static_cast<Id>(b), 1) == ErrorCode::ok)
      model[a].leader = b;
    std::vector<Changed> changed;
    for (std::size_t c = 0; c < kCount; ++c) {
      if (random.below(3) == 0) continue;
      constexpr std::size_t kOps[] = {0, 1, 3, kMostPoseOps};
      model[c].input = n;
      model[c].ops_before_cut = kOps[random.below(4)];
      model[c].asleep = random.below(8) == 0;
      changed.push_back({static_cast<Id>(c), crowd.input(c, n), model[c].ops_before_cut});
      changed.back().input.asleep = model[c].asleep;
    }
    const Result<Ticket> ticket = jobs.submit(changed);
    ASSERT_TRUE(ticket) << describe(ticket.error());
    while (!jobs.wait(*ticket)) {
      for (std::size_t c = 0; c < kCount; ++c)
        if (const CutPose* pose = jobs.cut_pose(static_cast<Id>(c))) push(pose->local, n + c);
      ASSERT_EQ(jobs.resume(), ErrorCode::ok);
    }
    ASSERT_EQ(jobs.last_error(), ErrorCode::ok);
    std::vector<bool> ready(kCount, false);
    for (std::size_t left = kCount; left > 0;)
      for (std::size_t c = 0; c < kCount; ++c) {
        Model& one = model[c];
        if (ready[c] || (one.leader && !ready[*one.leader])) continue;
        ready[c] = true;
        --left;
        if (one.input == 0 || (one.leader && model[*one.leader].joints.empty())) continue;  // keeps its last result
        FrameInput input = crowd.input(c, one.input);
        input.asleep = one.asleep;
        if (one.leader) input.root = model[*one.leader].joints[1] * input.root;
        FrameBuffer fresh(crowd.plan());
        CutPose pose;
        if (one.ops_before_cut == 0 || one.asleep) {
          ASSERT_EQ(run_plan(crowd.plan(), input, fresh), ErrorCode::ok);
        } else {
          ASSERT_EQ(run_to_cut(crowd.plan(), input, fresh, pose, one.ops_before_cut), ErrorCode::ok);
          push(pose.local, n + c);
          ASSERT_EQ(run_from_cut(crowd.plan(), input, fresh), ErrorCode::ok);
        }
        one.joints.assign(fresh.result().model.begin(), fresh.result().model.end());
        ASSERT_NE(jobs.latest(static_cast<Id>(c)), nullptr);
        ASSERT_EQ(first_difference(*jobs.latest(static_cast<Id>(c)), fresh.result()), "")
            << "seed " << seed << " frame " << n << " character " << c;
      }
  }
}

TEST(cut_crowd, random_cuts_and_followers_give_the_bits_of_frames_without_threads) {
  ThreadPool pool(3);
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    drive_cuts(seed, spread(pool.executor()));
    drive_cuts(seed, polled_cuts());
    drive_cuts(seed, polled_cuts(2));
    drive_cuts(seed, {});
  }
}

TEST(cut_crowd, tasks_of_both_halves_run_on_any_threads) {
  CutCrowd crowd(6);
  JobThread jobs(polled_cuts());
  std::vector<Changed> changed;
  for (std::size_t c = 0; c < 6; ++c) changed.push_back({jobs.add_character(crowd.plan()), {}, kMostPoseOps});
  std::atomic<bool> stop{false};
  std::thread helper([&] {
    while (!stop.load())
      if (const std::optional<JobThread::Task> task = jobs.take_task()) (*task)();
  });
  for (std::uint64_t n = 1; n <= 40; ++n) {
    for (std::size_t c = 0; c < 6; ++c) changed[c].input = crowd.input(c, n);
    const Ticket ticket = *jobs.submit(changed);
    while (!jobs.wait(ticket)) {
      for (const Changed& one : changed) push(jobs.cut_pose(one.character)->local, n);
      EXPECT_EQ(jobs.resume(), ErrorCode::ok);
    }
    FrameBuffer fresh(crowd.plan());
    CutPose pose;
    const FrameInput input = crowd.input(3, n);
    EXPECT_EQ(run_to_cut(crowd.plan(), input, fresh, pose), ErrorCode::ok);
    push(pose.local, n);
    EXPECT_EQ(run_from_cut(crowd.plan(), input, fresh), ErrorCode::ok);
    EXPECT_EQ(first_difference(*jobs.latest(changed[3].character), fresh.result()), "") << n;
  }
  stop = true;
  helper.join();
}

}  // namespace
}  // namespace sinew::test
