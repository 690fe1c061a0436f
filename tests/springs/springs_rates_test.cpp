// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <map>

#include "tests/springs/spring_stage.h"

namespace sinew {
namespace {

using test::figure_of_eight;
using test::HangingChain;
using test::SpringStage;
using Vec = Vec3<double>;
using Tails = std::vector<Vec>;

/// Tails at multiples of 1/12 s, which all rates have, over three seconds of the figure of eight.
std::map<int, Tails> swing(const HangingChain& chain, int fps) {
  SpringStage stage(chain.skeleton, chain.setup);
  std::map<int, Tails> out;
  for (int frame = 0; frame <= 3 * fps; ++frame) {
    stage.move_root(figure_of_eight(static_cast<double>(frame) / fps));
    stage.frame(1.0 / fps);
    if (frame * 12 % fps == 0) out[frame * 12 / fps] = stage.tails;
  }
  return out;
}

double largest_difference(const std::map<int, Tails>& a, const std::map<int, Tails>& b) {
  double worst = 0.0;
  for (const auto& [time, tails] : a)
    if (const auto found = b.find(time); found != b.end())
      for (std::size_t s = 0; s < tails.size(); ++s)
        worst = std::max(worst, test::distance(tails[s], found->second[s]));
  return worst;
}

void expect_agreement(const HangingChain& chain) {
  const auto at_60 = swing(chain, 60);
  const std::map<int, double> bounds_m = {{30, 5e-4},  {36, 4e-4},   {48, 2e-4},  {72, 6e-5},  {120, 1e-12},
                                          {144, 1e-5}, {240, 1e-12}, {300, 2e-6}, {1020, 2e-6}};
  for (const auto& [fps, bound] : bounds_m) {
    const double found = largest_difference(swing(chain, fps), at_60);
    EXPECT_LE(found, bound) << fps;
    ::testing::Test::RecordProperty("metres_at_" + std::to_string(fps), std::to_string(found));
  }
}

TEST(springs_rates, frames_of_any_rate_agree_with_60_hz) {
  for (const bool lagging : {false, true}) {
    HangingChain chain;
    for (SpringJoint& joint : chain.setup.joints) joint.lagging_length = lagging;
    expect_agreement(chain);
  }
}

/// Between ticks the tails move on smoothly: no step is much longer than at the rate of ticks.
TEST(springs_rates, tails_do_not_jump_at_ticks) {
  const HangingChain chain;
  SpringStage stage(chain.skeleton, chain.setup);
  Tails before;
  Vec last_step(0.0);
  double worst = 0.0;
  for (int frame = 0; frame <= 2880; ++frame) {
    stage.move_root(figure_of_eight(frame / 960.0));
    stage.frame(1.0 / 960.0);
    const Vec tail = stage.tails.back();
    if (!before.empty() && frame > 16) {
      const Vec step = tail - before.back();
      if (frame > 17) worst = std::max(worst, test::distance(step, last_step));
      last_step = step;
    }
    before = stage.tails;
  }
  // A tail that stood still between ticks would jump by 50 mm and more.
  EXPECT_LE(worst, 2.5e-3);
}

TEST(springs_rates, a_frame_between_ticks_leaves_the_ticks_alone) {
  const HangingChain chain;
  SpringStage whole(chain.skeleton, chain.setup), parts(chain.skeleton, chain.setup);
  whole.frame(0.0);
  parts.frame(0.0);
  for (int frame = 1; frame <= 60; ++frame) {
    const Vec from = figure_of_eight((frame - 1) / 60.0), to = figure_of_eight(frame / 60.0);
    whole.move_root(to);
    whole.frame(1.0 / 60.0);
    for (int part = 1; part <= 4; ++part) {
      parts.move_root(from + (to - from) * (part / 4.0));
      parts.frame(1.0 / 240.0);
    }
    for (std::size_t s = 0; s < 4; ++s) ASSERT_TRUE(test::is_near(parts.tails[s], whole.tails[s], 1e-9)) << frame;
  }
}

/// eq  A tail that is free loses (1 - drag)^(60 t) of its velocity, and gains 60 gravity t.
TEST(springs_rates, another_tick_has_nearly_the_same_drag_and_pull) {
  HangingChain chain(1);
  chain.setup.joints[0] = {
      .joint = 1, .tail_m = {0.0, -1e4, 0.0}, .stiffness = 0.0, .drag = 0.05, .gravity_m_s = {0.1, 0.0, 0.0}};
  std::vector<double> moved;
  for (const double tick_s : {1.0 / 60.0, 1.0 / 240.0, 1.0 / 960.0}) {
    SpringSettings settings;
    settings.tick_s = tick_s;
    settings.max_ticks = 32;
    settings.sleep_rad_per_s = 0.0;  // the bone is too long to turn fast
    SpringStage stage(chain.skeleton, chain.setup, settings);
    for (int frame = 0; frame <= 60; ++frame) stage.frame(1.0 / 60.0);
    moved.push_back(stage.tails[0].x);
  }
  EXPECT_GT(moved[0], 1.0);
  EXPECT_NEAR(moved[1] / moved[2], 1.0, 0.02);
  EXPECT_NEAR(moved[0] / moved[2], 1.0, 0.05);
}

TEST(springs_rates, a_long_frame_takes_a_bounded_number_of_ticks) {
  const HangingChain chain;
  SpringStage stage(chain.skeleton, chain.setup);
  stage.frame(0.0);
  stage.move_root({1.0, 0.0, 0.0});
  stage.frame(10.0);
  EXPECT_EQ(stage.counts.ticks, 8u);
  EXPECT_EQ(stage.counts.dropped_ticks, 592u);
  for (const Vec& tail : stage.tails) EXPECT_LT(glm::length(tail), 7.0);
  stage.frame(1.0 / 60.0);
  EXPECT_EQ(stage.counts.ticks, 1u);
  EXPECT_EQ(stage.counts.dropped_ticks, 0u);
}

TEST(springs_rates, no_time_changes_nothing) {
  const HangingChain chain;
  SpringStage stage(chain.skeleton, chain.setup);
  for (int frame = 0; frame < 30; ++frame) {
    stage.move_root(figure_of_eight(frame / 60.0));
    stage.frame(1.0 / 60.0);
  }
  const Tails before = stage.tails;
  for (int frame = 0; frame < 5; ++frame) {
    stage.frame(0.0);
    EXPECT_EQ(stage.counts.ticks, 0u);
    for (std::size_t s = 0; s < 4; ++s) EXPECT_TRUE(test::is_near(stage.tails[s], before[s], 1e-14));
  }
}

}  // namespace
}  // namespace sinew
