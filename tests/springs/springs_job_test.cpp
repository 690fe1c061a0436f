// SPDX-License-Identifier: MIT
#include "runtime/procedures/springs/springs_job.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>

#include "tests/springs/spring_stage.h"
#include "tests/support/allocation_counter.h"

namespace sinew {
namespace {

using test::figure_of_eight;
using test::HangingChain;
using test::SpringStage;
using Vec = Vec3<double>;

/// Frames of the figure of eight from frame `first` on, at 60 Hz.
void swing(SpringStage& stage, int first, int last, const Vec& origin = Vec(0.0)) {
  for (int frame = first; frame < last; ++frame) {
    stage.move_root(origin + figure_of_eight(frame / 60.0));
    stage.frame(1.0 / 60.0);
  }
}

TEST(springs_job, hangs_still_where_its_goal_is) {
  const HangingChain chain;
  SpringStage stage(chain.skeleton, chain.setup);
  for (int frame = 0; frame < 10; ++frame) stage.frame(1.0 / 60.0);
  for (std::size_t s = 0; s < 4; ++s)
    EXPECT_TRUE(test::is_near(stage.tails[s], Vec(0.0, -2.0 - static_cast<double>(s), 0.0), 1e-12));
}

/// eq  one tick by hand: the tail stays behind, stiffness pulls it down, and the bone keeps its length
TEST(springs_job, one_tick_by_hand) {
  HangingChain chain(1);
  chain.setup.joints[0].gravity_m_s = {0.0, 0.0, 0.6};
  SpringStage stage(chain.skeleton, chain.setup);
  stage.frame(0.0);
  stage.move_root({0.1, 0.0, 0.0});
  stage.frame(1.0 / 60.0);
  const Vec head(0.1, -1.0, 0.0), expected = head + glm::normalize(Vec(-0.1, -1.0 - 1.0 / 60.0, 0.01));
  EXPECT_TRUE(test::is_near(stage.tails[0], expected, 1e-15));
  EXPECT_EQ(stage.counts.ticks, 1u);
  EXPECT_EQ(stage.counts.joints, 1u);
}

TEST(springs_job, a_copied_state_goes_on_with_the_same_bits) {
  const HangingChain chain;
  SpringStage stage(chain.skeleton, chain.setup);
  swing(stage, 0, 40);
  const auto saved = stage.state;
  swing(stage, 40, 90);
  const auto first = stage.tails;
  const auto state = stage.state;
  stage.state = saved;
  swing(stage, 40, 90);
  EXPECT_EQ(std::memcmp(first.data(), stage.tails.data(), sizeof(Vec) * first.size()), 0);
  EXPECT_EQ(state, stage.state);
}

TEST(springs_job, allocates_nothing) {
  const HangingChain chain;
  SpringStage stage(chain.skeleton, chain.setup);
  stage.frame(0.0);
  const SpringsJob job = stage.job(1.0 / 50.0);
  const test::AllocationCounter counter;
  EXPECT_EQ(run(job), ErrorCode::ok);
  EXPECT_EQ(counter.count(), 0u);
}

TEST(springs_job, sleeps_when_nothing_moves_and_wakes_with_its_input) {
  const HangingChain chain;
  SpringStage stage(chain.skeleton, chain.setup);
  swing(stage, 0, 60);
  int frames = 0;
  while (!stage.counts.asleep && ++frames < 2000) stage.frame(1.0 / 60.0);
  ASSERT_LT(frames, 2000);
  const auto still = stage.tails;
  const glm::quat rotation = stage.rotation(2);
  for (int frame = 0; frame < 5; ++frame) {
    stage.frame(1.0 / 60.0);
    EXPECT_EQ(stage.counts.ticks, 0u);
    EXPECT_EQ(stage.counts.joints, 0u);
    EXPECT_EQ(stage.rotation(2), rotation);
    for (std::size_t s = 0; s < 4; ++s) EXPECT_TRUE(test::is_near(stage.tails[s], still[s], 1e-9));
  }
  stage.pose[0].translation.x += 0.01f;
  stage.frame(1.0 / 60.0);
  EXPECT_FALSE(stage.counts.asleep);
  EXPECT_EQ(stage.counts.ticks, 1u);
  EXPECT_GT(test::distance(stage.tails[3], still[3]), 1e-5);
}

TEST(springs_job, teleport_keeps_the_swing_relative_to_the_root) {
  const HangingChain chain;
  SpringStage there(chain.skeleton, chain.setup), here(chain.skeleton, chain.setup);
  const Vec far(300.0, 20.0, -7.0);
  swing(there, 0, 40);
  swing(here, 0, 40);
  there.event = SpringEvent::teleport;
  there.move_root(figure_of_eight(39 / 60.0) + far);
  there.frame(0.0);
  for (int frame = 40; frame < 80; ++frame) {
    swing(there, frame, frame + 1, far);
    swing(here, frame, frame + 1);
    for (std::size_t s = 0; s < 4; ++s) ASSERT_TRUE(test::is_near(there.tails[s] - far, here.tails[s], 1e-9)) << frame;
  }
}

/// One frame takes from a microsecond to the largest double. All frames after it tick as before.
TEST(springs_job, go_on_at_their_rate_after_a_frame_of_any_length) {
  const HangingChain chain;
  for (const double long_s : {1e-6, 10.0, 1e6, 1e12, 1e15, 1e17, 1e300, (std::numeric_limits<double>::max)()}) {
    SpringStage stage(chain.skeleton, chain.setup);
    swing(stage, 0, 20);
    stage.frame(long_s);
    EXPECT_LE(stage.counts.ticks, 9u);
    std::uint32_t ticks = 0;
    for (int frame = 0; frame < 60; ++frame) {
      stage.move_root(figure_of_eight(frame / 60.0));
      stage.frame(1.0 / 60.0);
      EXPECT_EQ(stage.counts.dropped_ticks, 0u) << long_s;
      ticks += stage.counts.ticks;
    }
    EXPECT_GE(ticks, 60u) << long_s;
    EXPECT_LE(ticks, 121u) << long_s;
  }
}

TEST(springs_job, reset_takes_the_goal_at_once) {
  const HangingChain chain;
  SpringStage stage(chain.skeleton, chain.setup);
  swing(stage, 0, 40);
  stage.event = SpringEvent::reset;
  stage.move_root({5.0, 0.0, 0.0});
  stage.frame(1.0 / 60.0);
  for (std::size_t s = 0; s < 4; ++s)
    EXPECT_TRUE(test::is_near(stage.tails[s], Vec(5.0, -2.0 - static_cast<double>(s), 0.0), 1e-12));
}

TEST(springs_job, swings_alike_a_hundred_kilometres_away) {
  const HangingChain chain;
  SpringStage near(chain.skeleton, chain.setup), far(chain.skeleton, chain.setup);
  const Vec origin(1e5, 0.0, -1e5);
  swing(near, 0, 120);
  swing(far, 0, 120, origin);
  for (std::size_t s = 0; s < 4; ++s) {
    EXPECT_TRUE(test::is_near(far.tails[s] - origin, near.tails[s], 1e-8));
    EXPECT_TRUE(test::same_rotation(far.rotation(s + 1), near.rotation(s + 1), 1e-6));
  }
}

/// A root of scale -3 is a half turn and a mirror: the chain hangs up, three times as long.
TEST(springs_job, a_mirroring_root_turns_goals_and_lengths) {
  const HangingChain chain;
  SpringStage stage(chain.skeleton, chain.setup);
  for (int r = 0; r < 3; ++r) stage.root.row[r][r] = -3.0;
  swing(stage, 0, 30);
  double length = glm::length(stage.tails[3] - stage.tails[2]);
  EXPECT_NEAR(length, 3.0, 1e-9);
  EXPECT_GT(stage.tails[0].y, 3.0);
  for (int frame = 0; frame < 600; ++frame) stage.frame(1.0 / 60.0);
  EXPECT_TRUE(test::is_near(stage.tails[3], figure_of_eight(29 / 60.0) + Vec(0.0, 15.0, 0.0), 2e-2));
}

TEST(springs_job, a_collider_around_the_whole_chain_leaves_it_finite) {
  HangingChain chain;
  chain.setup.colliders.push_back({.joint = 0, .offset = {0.0, -3.0, 0.0}, .radius_m = 50.0});
  chain.setup.groups[0].colliders = {0};
  SpringStage stage(chain.skeleton, chain.setup);
  swing(stage, 0, 120);
  for (std::size_t s = 1; s < 4; ++s) EXPECT_NEAR(glm::length(stage.tails[s] - stage.tails[s - 1]), 1.0, 1e-9);
}

TEST(springs_job, an_inner_collider_keeps_tails_inside) {
  HangingChain chain(1);
  chain.setup.joints[0].gravity_m_s = {20.0, 0.0, 0.0};
  chain.setup.joints[0].hit_radius_m = 0.1;
  chain.setup.colliders.push_back({.joint = 0, .offset = {0.0, -2.0, 0.0}, .radius_m = 0.5, .inside = true});
  chain.setup.groups[0].colliders = {0};
  SpringStage stage(chain.skeleton, chain.setup);
  for (int frame = 0; frame < 60; ++frame) stage.frame(1.0 / 60.0);
  // Keeping the length after the push leaves the tail slightly outside.
  EXPECT_LE(glm::length(stage.tails[0] - Vec(0.0, -2.0, 0.0)), 0.42);
  EXPECT_GE(glm::length(stage.tails[0] - Vec(0.0, -2.0, 0.0)), 0.38);
}

TEST(springs_job, bones_without_length_are_carried) {
  HangingChain chain;
  chain.setup.joints[1].tail_m = Vec(0.0);
  SpringStage stage(chain.skeleton, chain.setup);
  swing(stage, 0, 40);
  EXPECT_EQ(stage.rotation(2), quat_identity<float>());
  EXPECT_TRUE(test::is_near(stage.tails[1], stage.tails[0], 1e-6));
  for (const Vec& tail : stage.tails) EXPECT_TRUE(std::isfinite(glm::length(tail)));
}

TEST(springs_job, a_broken_pose_is_forgotten_in_the_next_frame) {
  const HangingChain chain;
  SpringStage stage(chain.skeleton, chain.setup);
  swing(stage, 0, 10);
  const Transform sound = stage.pose[0];
  stage.pose[0].translation.x = std::numeric_limits<float>::quiet_NaN();
  stage.frame(1.0 / 60.0);
  stage.pose[0] = sound;
  swing(stage, 11, 20);
  for (const Vec& tail : stage.tails) EXPECT_TRUE(std::isfinite(glm::length(tail)));
}

TEST(springs_job, weight_mixes_with_the_animated_rotation) {
  const HangingChain chain;
  SpringStage whole(chain.skeleton, chain.setup), half(chain.skeleton, chain.setup), none(chain.skeleton, chain.setup);
  half.weight = 0.5f;
  none.weight = 0.0f;
  for (SpringStage* stage : {&whole, &half, &none}) swing(*stage, 0, 20);
  const double turn = test::angle_between(whole.rotation(1), quat_identity<float>());
  EXPECT_GT(turn, 0.1);
  EXPECT_NEAR(test::angle_between(half.rotation(1), quat_identity<float>()), 0.5 * turn, 1e-6);
  EXPECT_EQ(none.rotation(1), quat_identity<float>());
}

TEST(springs_job, refuses_what_does_not_fit) {
  const HangingChain chain;
  SpringStage stage(chain.skeleton, chain.setup);
  const SpringsJob sound = stage.job(0.0);
  ASSERT_EQ(check(sound), ErrorCode::ok);
  const auto code_with = [&](const auto& change) {
    SpringsJob job = sound;
    change(job);
    return check(job);
  };
  const Skeleton other = test::chain_skeleton(3);
  EXPECT_EQ(code_with([](SpringsJob& j) { j.springs = nullptr; }), ErrorCode::size_mismatch);
  EXPECT_EQ(code_with([&](SpringsJob& j) { j.skeleton = &other; }), ErrorCode::size_mismatch);
  EXPECT_EQ(code_with([](SpringsJob& j) { j.pose.joint_count = 2; }), ErrorCode::size_mismatch);
  EXPECT_EQ(code_with([](SpringsJob& j) { j.state = j.state.first(8); }), ErrorCode::size_mismatch);
  EXPECT_EQ(code_with([](SpringsJob& j) { j.state = j.state.subspan(4); }), ErrorCode::size_mismatch);
  EXPECT_EQ(code_with([](SpringsJob& j) { j.scratch = j.scratch.first(8); }), ErrorCode::size_mismatch);
  EXPECT_EQ(code_with([](SpringsJob& j) { j.tails = j.tails.first(1); }), ErrorCode::size_mismatch);
  EXPECT_EQ(code_with([](SpringsJob& j) {
              j.scratch = {j.state.data(), j.scratch.size()};
            }),
            ErrorCode::overlapping_buffers);
  EXPECT_EQ(code_with([](SpringsJob& j) { j.root.row[1].w = std::numeric_limits<double>::infinity(); }),
            ErrorCode::not_finite);
  EXPECT_EQ(code_with([](SpringsJob& j) { j.dt_s = std::numeric_limits<double>::quiet_NaN(); }), ErrorCode::not_finite);
  EXPECT_EQ(code_with([](SpringsJob& j) { j.dt_s = -0.1; }), ErrorCode::times_not_increasing);
  EXPECT_EQ(code_with([](SpringsJob& j) { j.weight = 1.5f; }), ErrorCode::not_a_fraction);
}

}  // namespace
}  // namespace sinew
