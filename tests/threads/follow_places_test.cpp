// SPDX-License-Identifier: MIT
// Overrides and targets of procedures that follow joints of other characters of a job thread.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "runtime/math/decompose.h"
#include "runtime/math/inverse.h"
#include "runtime/threads/follow_order.h"
#include "tests/plan/frame_equality.h"
#include "tests/scenes/hand_scenes.h"
#include "tests/support/allocation_counter.h"
#include "tests/support/fixed_random.h"
#include "tests/threads/crowd.h"
#include "tests/threads/thread_executor.h"

namespace sinew::test {
namespace {

using Id = JobThread::Character;
using Changed = JobThread::CharacterInput;

constexpr FollowPlace kOverride{FollowKind::joint_override, 1, 1, nullptr};

/// Arms whose programs have two lists of overrides and a procedure that moves joint 1 to its target.
class Reachers {
 public:
  explicit Reachers(std::size_t count) : own_(count), scene_(arm_scene()) {
    for (Own& own : own_) {
      own.lists = {JointOverrides{std::span(own.joints).first(1), 1}, JointOverrides{std::span(own.joints).last(2), 1}};
      own.program.sample(0, 0.0).override_joints(0, 0.5).override_joints(1, 0.75).procedure(0);
    }
    Needs needs;
    needs.in.program = room_of(own_[0].program.ops());
    needs.in.program.overridden_joints = 3;
    plan_ = compile_plan(lend(scene_), needs);
  }

  const Plan& plan() const { return plan_; }
  FollowPlace target(std::size_t c) { return {FollowKind::procedure, 0, 0, &own_[c].target}; }
  JointOverride& followed_override(std::size_t c) { return own_[c].joints[2]; }
  JointOverrides& followed_list(std::size_t c) { return own_[c].lists[1]; }

  FrameInput input(std::size_t c, std::uint64_t number, Affine* target = nullptr) {
    Own& own = own_[c];
    own.program.clear();
    own.program.sample(0, 0.01 * static_cast<double>(number % 50)).override_joints(0, 0.5);
    own.program.override_joints(1, 0.75).procedure(0);
    own.procedure = {&reach, target != nullptr ? target : &own.target, 7};
    FrameInput input{.program = own.program.ops()};
    input.program_inputs.overrides = own.lists;
    input.program_inputs.procedures = {&own.procedure, 1};
    input.root = affine_from_transform(
        Transform{{static_cast<float>(c), 0.5f, 0.25f}, quat_xyzw(0.0f, 0.6f, 0.0f, 0.8f), glm::vec3(2.0f)});
    return input;
  }

 private:
  struct Own {
    std::array<JointOverride, 3> joints{{{0, {}, OverrideSpace::local},
                                         {1, {}, OverrideSpace::local},
                                         {2, {{0.1f, 0.2f, 0.3f}}, OverrideSpace::model}}};
    std::array<JointOverrides, 2> lists;
    Affine target;
    PoseProcedure procedure;
    PoseProgram program;
  };

  static void reach(void* context, const ProcedurePose& pose) {
    const glm::vec3 to = translation_of(*static_cast<const Affine*>(context));
    pose.local.plane(PoseSpan::tx)[1] += to.x;
    pose.local.plane(PoseSpan::ty)[1] += to.y;
  }

  std::vector<Own> own_;
  Scene scene_;
  Plan plan_;
};

/// The joint of a leader in the model space of a follower.
Affine in_model_space(const FrameInput& follower, const Affine& joint) { return *inverse_of(follower.root) * joint; }

JointOverride placed(JointOverride given, const Affine& joint) {
  given.transform = decompose_trs(joint * affine_from_transform(given.transform)).transform;
  return given;
}

JobThreadOptions polled_followers() {
  JobThreadOptions options = spread();
  options.own_thread = false;
  return options;
}

TEST(follow_places, an_override_and_a_target_follow_a_joint_in_the_same_frame) {
  Reachers reachers(3);
  JobThread jobs(spread());
  for (Id c = 0; c < 3; ++c) ASSERT_EQ(jobs.add_character(reachers.plan()), c);
  ASSERT_EQ(jobs.follow(0, 1, 2, kOverride), ErrorCode::ok);
  ASSERT_EQ(jobs.follow(0, 2, 2, reachers.target(0)), ErrorCode::ok);
  for (std::uint64_t n = 1; n < 6; ++n) {
    std::vector<Changed> changed;
    for (Id c = 0; c < 3; ++c) changed.push_back({c, reachers.input(c, n * (c + 1)), 0});
    ASSERT_TRUE(jobs.wait(*jobs.submit(changed)));
    ASSERT_EQ(jobs.last_error(), ErrorCode::ok);
    Affine target = in_model_space(changed[0].input, jobs.latest(2)->model[2]);
    FrameInput alone = reachers.input(0, n, &target);
    const JointOverride lists[] = {
        alone.program_inputs.overrides[1].joints[0],
        placed(reachers.followed_override(0), in_model_space(alone, jobs.latest(1)->model[2]))};
    const JointOverrides both[] = {alone.program_inputs.overrides[0], {lists, 1}};
    alone.program_inputs.overrides = both;
    FrameBuffer fresh(reachers.plan());
    ASSERT_EQ(run_plan(reachers.plan(), alone, fresh), ErrorCode::ok);
    EXPECT_EQ(first_difference(*jobs.latest(0), fresh.result()), "") << n;
  }
}

TEST(follow_places, unchanged_targets_run_nothing_and_each_change_of_a_leader_runs_the_follower) {
  Reachers reachers(2);
  JobThread jobs(polled_followers());
  for (Id c = 0; c < 2; ++c) ASSERT_EQ(jobs.add_character(reachers.plan()), c);
  ASSERT_EQ(jobs.follow(0, 1, 2, kOverride), ErrorCode::ok);
  const auto run = [&](std::span<const Changed> changed) { ASSERT_TRUE(jobs.wait(*jobs.submit(changed))); };
  run(std::vector<Changed>{{0, reachers.input(0, 1), 0}, {1, reachers.input(1, 1), 0}});
  run({});
  EXPECT_EQ(jobs.latest(0)->frame, 1u);
  run(std::vector<Changed>{{1, reachers.input(1, 2), 0}});
  EXPECT_EQ(jobs.latest(0)->frame, 3u) << "the leader moved";
  ASSERT_EQ(jobs.follow(0, 1, 2, reachers.target(0)), ErrorCode::ok);
  run({});
  EXPECT_EQ(jobs.latest(0)->frame, 4u) << "another place follows";
  run({});
  EXPECT_EQ(jobs.latest(0)->frame, 4u);
  FrameInput asleep = reachers.input(1, 2);
  asleep.asleep = true;
  const Affine before = jobs.latest(0)->model[2];
  run(std::vector<Changed>{{1, asleep, 0}});
  EXPECT_EQ(jobs.latest(0)->frame, 6u) << "the override is where its input says";
  EXPECT_NE(jobs.latest(0)->model[2], before);
  for (const FollowPlace& place : {kOverride, reachers.target(0)})
    ASSERT_EQ(jobs.stop_following(0, place), ErrorCode::ok);
  run(std::vector<Changed>{{1, reachers.input(1, 3), 0}});
  EXPECT_EQ(jobs.latest(0)->frame, 6u) << "nothing follows any more";
  reachers.followed_list(0).version = 0;
  run(std::vector<Changed>{{0, reachers.input(0, 1), 0}});
  ASSERT_EQ(jobs.follow(0, 1, 2, kOverride), ErrorCode::ok);
  run({});
  run({});
  EXPECT_EQ(jobs.latest(0)->frame, 10u) << "content of version 0 may differ in each frame";
}

TEST(follow_places, faults_are_named) {
  Reachers reachers(3);
  JobThread jobs(polled_followers());
  for (Id c = 0; c < 3; ++c) ASSERT_EQ(jobs.add_character(reachers.plan()), c);
  EXPECT_EQ(jobs.follow(0, 1, 2, {FollowKind::procedure, 0, 0, nullptr}), ErrorCode::size_mismatch);
  EXPECT_EQ(jobs.follow(0, 0, 2, kOverride), ErrorCode::follows_itself);
  EXPECT_EQ(jobs.follow(0, 9, 2, kOverride), ErrorCode::unknown_character);
  EXPECT_EQ(jobs.follow(0, 1, 99, kOverride), ErrorCode::index_out_of_range);
  ASSERT_EQ(jobs.follow(0, 1, 2), ErrorCode::ok);
  ASSERT_EQ(jobs.follow(1, 2, 2, reachers.target(1)), ErrorCode::ok);
  EXPECT_EQ(jobs.follow(2, 0, 2, kOverride), ErrorCode::follows_itself) << "by another kind of place at each step";
  std::vector<Changed> changed;
  for (Id c = 0; c < 3; ++c) changed.push_back({c, reachers.input(c, 1), 0});
  const auto error_of = [&](FollowPlace place) {
    EXPECT_EQ(jobs.follow(0, 2, 2, place), ErrorCode::ok);
    EXPECT_TRUE(jobs.wait(*jobs.submit(changed)));
    EXPECT_EQ(jobs.latest(0), nullptr);
    EXPECT_EQ(jobs.stop_following(0, place), ErrorCode::ok);
    return jobs.last_error();
  };
  Affine other;
  EXPECT_EQ(error_of({FollowKind::joint_override, 2, 0, nullptr}), ErrorCode::index_out_of_range);
  EXPECT_EQ(error_of({FollowKind::joint_override, 1, 2, nullptr}), ErrorCode::index_out_of_range);
  EXPECT_EQ(error_of({FollowKind::procedure, 1, 0, &other}), ErrorCode::index_out_of_range);
  EXPECT_EQ(error_of({FollowKind::joint_override, 1, 0, nullptr}), ErrorCode::unsupported) << "in local space";
  changed[0].input.root.row[1] = {};
  EXPECT_EQ(error_of(kOverride), ErrorCode::rank_deficient);
  changed[0].input = reachers.input(0, 1);
  ASSERT_TRUE(jobs.wait(*jobs.submit(changed)));
  EXPECT_EQ(jobs.last_error(), ErrorCode::ok);
}

/// Characters with roots, overrides and targets that follow each other at random. All results are those of frames
/// without threads that get the same numbers from their leaders.
void drive_places(std::uint64_t seed, JobThreadOptions options) {
  constexpr std::size_t kCount = 8;
  Reachers reachers(kCount);
  JobThread jobs(std::move(options));
  FixedRandom random(seed);
  using Leader = std::optional<std::size_t>;
  struct Model {
    std::uint64_t input = 1;
    Leader of_root, of_override, of_target;
    std::vector<Affine> joints;
  };
  std::vector<Model> model(kCount);
  std::vector<Changed> all;
  for (std::size_t c = 0; c < kCount; ++c) {
    ASSERT_EQ(jobs.add_character(reachers.plan()), c);
    all.push_back({static_cast<Id>(c), reachers.input(c, 1), 0});
  }
  jobs.wait(*jobs.submit(all));
  for (std::uint64_t n = 2; n < 80; ++n) {
    const std::size_t c = random.below(kCount), leader = random.below(kCount);
    const std::uint32_t what = random.below(3);
    const FollowPlace place = what == 0 ? FollowPlace{} : what == 1 ? kOverride : reachers.target(c);
    Leader& of = what == 0 ? model[c].of_root : what == 1 ? model[c].of_override : model[c].of_target;
    if (random.below(4) == 0) {
      ASSERT_EQ(jobs.stop_following(static_cast<Id>(c), place), ErrorCode::ok);
      of.reset();
    } else if (jobs.follow(static_cast<Id>(c), static_cast<Id>(leader), 2, place) == ErrorCode::ok) {
      of = leader;
    }
    std::vector<Changed> changed;
    for (std::size_t i = 0; i < kCount; ++i) {
      // A target that nobody sets any more keeps its last matrix, so the model only looks at targets that follow.
      if (random.below(3) == 0 || !model[i].of_target) changed.push_back({static_cast<Id>(i), reachers.input(i, n), 0});
      if (!changed.empty() && changed.back().character == i) model[i].input = n;
    }
    ASSERT_TRUE(jobs.wait(*jobs.submit(changed)));
    ASSERT_EQ(jobs.last_error(), ErrorCode::ok);
    std::vector<bool> ready(kCount, false);
    for (std::size_t left = kCount; left > 0;)
      for (std::size_t i = 0; i < kCount; ++i) {
        const Model& one = model[i];
        const auto waits = [&](const Leader& l) { return l && !ready[*l]; };
        if (ready[i] || waits(one.of_root) || waits(one.of_override) || waits(one.of_target)) continue;
        ready[i] = true;
        --left;
        Affine target = *reachers.target(i).matrix;
        FrameInput alone = reachers.input(i, one.input, &target);
        if (one.of_root) alone.root = model[*one.of_root].joints[2] * alone.root;
        if (one.of_target) target = in_model_space(alone, model[*one.of_target].joints[2]);
        std::array<JointOverride, 2> last{alone.program_inputs.overrides[1].joints[0], reachers.followed_override(i)};
        if (one.of_override) last[1] = placed(last[1], in_model_space(alone, model[*one.of_override].joints[2]));
        const JointOverrides lists[] = {alone.program_inputs.overrides[0], {last, 1}};
        alone.program_inputs.overrides = lists;
        FrameBuffer fresh(reachers.plan());
        ASSERT_EQ(run_plan(reachers.plan(), alone, fresh), ErrorCode::ok);
        ASSERT_EQ(first_difference(*jobs.latest(static_cast<Id>(i)), fresh.result()), "")
            << "seed " << seed << " frame " << n << " character " << i;
        model[i].joints.assign(fresh.result().model.begin(), fresh.result().model.end());
      }
  }
}

TEST(follow_places, random_followers_give_the_bits_of_frames_without_threads) {
  ThreadPool pool(3);
  for (std::uint64_t seed = 1; seed <= 6; ++seed) {
    drive_places(seed, spread(pool.executor()));
    drive_places(seed, polled_followers());
  }
}

TEST(follow_places, frames_allocate_nothing) {
  Reachers reachers(4);
  JobThread jobs(polled_followers());
  std::vector<Changed> changed;
  for (Id c = 0; c < 4; ++c) changed.push_back({jobs.add_character(reachers.plan()), {}, 0});
  for (Id c = 1; c < 4; ++c) {
    ASSERT_EQ(jobs.follow(c, c - 1, 2, kOverride), ErrorCode::ok);
    ASSERT_EQ(jobs.follow(c, 0, 2, reachers.target(c)), ErrorCode::ok);
    for (std::uint64_t n = 1; n < 4; ++n) {
      for (Id i = 0; i < 4; ++i) changed[i].input = reachers.input(i, n + c);
      const AllocationCounter allocations;
      jobs.wait(*jobs.submit(changed));
      EXPECT_EQ(jobs.last_error(), ErrorCode::ok);
      EXPECT_EQ(allocations.count(), 0u);
    }
  }
}

TEST(follow_order, leaders_come_first_and_groups_stay_together) {
  FixedRandom random(3);
  FollowOrder order;
  constexpr std::uint32_t kCount = 40;
  order.reserve(kCount);
  for (int round = 0; round < 50; ++round) {
    std::vector<FollowLink> links;
    for (std::uint32_t f = 0; f < kCount; ++f)
      for (std::uint32_t l = random.below(3); l-- > 0 && f > 0;)
        if (round % 5 != 0) links.push_back({f, f - 1 - random.below(f), 0, {}});
    // Roles are dealt anew, so that leaders have larger indices than their followers, too.
    for (FollowLink& link : links) {
      link.follower = (link.follower * 7 + 3) % kCount;
      link.leader = (link.leader * 7 + 3) % kCount;
    }
    std::stable_sort(links.begin(), links.end(), [](auto& a, auto& b) { return a.follower < b.follower; });
    std::vector<std::uint32_t> indices(kCount), place(kCount, kCount), group(kCount);
    for (std::uint32_t i = 0; i < kCount; ++i) indices[i] = (i * 11) % kCount;
    const std::span<const FollowOrder::Position> sorted = order.sort(indices, links);
    ASSERT_EQ(sorted.size(), kCount);
    std::uint32_t groups = 0;
    for (std::uint32_t p = 0; p < kCount; ++p) {
      groups += sorted[p].begins_group;
      ASSERT_EQ(place[sorted[p].index], kCount) << "each comes once";
      place[sorted[p].index] = p;
      group[sorted[p].index] = groups;
    }
    EXPECT_TRUE(!links.empty() || groups == kCount);
    for (const FollowLink& link : links) {
      EXPECT_LT(place[link.leader], place[link.follower]);
      EXPECT_EQ(group[link.leader], group[link.follower]);
      EXPECT_TRUE(follows(links, kCount, link.follower, link.leader));
      EXPECT_FALSE(follows(links, kCount, link.leader, link.follower));
    }
  }
}

}  // namespace
}  // namespace sinew::test
