// SPDX-License-Identifier: MIT
#include "runtime/lod/update_rate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "runtime/base/same_bits.h"
#include "runtime/plan/run_plan.h"
#include "tests/scenes/hand_scenes.h"
#include "tests/scenes/random_scene.h"
#include "tests/support/allocation_counter.h"

namespace sinew::test {
namespace {

constexpr UpdateLevel kLevels[] = {UpdateLevel::every, UpdateLevel::every_second, UpdateLevel::every_fourth};
constexpr double kFrame_s = 1.0 / 60.0;

std::uint64_t period_of(UpdateLevel level) { return std::uint64_t{1} << static_cast<unsigned>(level); }

TEST(update_rate, smaller_characters_are_evaluated_less_often) {
  EXPECT_EQ(update_level(1.0, UpdateLevel::every), UpdateLevel::every);
  EXPECT_EQ(update_level(0.1, UpdateLevel::every), UpdateLevel::every_second);
  EXPECT_EQ(update_level(0.01, UpdateLevel::every), UpdateLevel::every_fourth);
  EXPECT_EQ(update_level(INFINITY, UpdateLevel::every_fourth), UpdateLevel::every);
  for (const UpdateLevel before : kLevels) {
    UpdateLevel last = UpdateLevel::every_fourth;
    for (double size = 0.0; size < 1.0; size += 0.001) {
      const UpdateLevel level = update_level(size, before);
      EXPECT_LE(level, last);  // a larger character is never updated less often
      last = level;
    }
  }
}

TEST(update_rate, a_character_that_trembles_at_a_border_keeps_its_level) {
  const UpdateRates rates;
  for (const double border : {rates.second_below, rates.fourth_below}) {
    UpdateLevel level = update_level(1.2 * border, UpdateLevel::every);
    int changes = 0;
    for (int i = 0; i < 100; ++i) {
      const UpdateLevel next = update_level(border * (i % 2 == 0 ? 0.95 : 1.2), level);
      changes += next != level;
      level = next;
    }
    EXPECT_EQ(changes, 1);
    EXPECT_LT(update_level(1.3 * border, level), level);
  }
}

TEST(update_rate, a_size_at_a_border_belongs_to_the_finer_level) {
  const UpdateRates rates;
  const auto below = [](double size) { return std::nextafter(size, 0.0); };
  for (const UpdateLevel coarse : {UpdateLevel::every_second, UpdateLevel::every_fourth}) {
    const auto fine = static_cast<UpdateLevel>(static_cast<int>(coarse) - 1);
    const double border = coarse == UpdateLevel::every_second ? rates.second_below : rates.fourth_below,
                 back = border * (1.0 + rates.hysteresis);
    EXPECT_EQ(update_level(border, fine), fine);
    EXPECT_EQ(update_level(below(border), fine), coarse);
    EXPECT_EQ(update_level(back, coarse), fine) << "on the way back";
    EXPECT_EQ(update_level(below(back), coarse), coarse);
  }
}

TEST(update_rate, where_frames_are_slow_fewer_are_left_out) {
  const auto limited = [](double frames_per_s) { return limited_level(UpdateLevel::every_fourth, 1.0 / frames_per_s); };
  EXPECT_EQ(limited(60.0), UpdateLevel::every_fourth);
  EXPECT_EQ(limited(41.0), UpdateLevel::every_fourth);
  EXPECT_EQ(limited(30.0), UpdateLevel::every_second);
  EXPECT_EQ(limited(19.0), UpdateLevel::every);
  EXPECT_EQ(limited_level(UpdateLevel::every_second, 1.0 / 240.0), UpdateLevel::every_second) << "never coarser";
  EXPECT_EQ(limited_level(UpdateLevel::every, 10.0), UpdateLevel::every);
  EXPECT_EQ(limited_level(UpdateLevel::every_second, 0.25, {.longest_s = 0.5}), UpdateLevel::every_second)
      << "as long as it may take";
  EXPECT_EQ(limited_level(UpdateLevel::every_fourth, 10.0, {.longest_s = 100.0}), UpdateLevel::every_fourth);
}

TEST(update_rate, screen_size_is_the_height_in_the_picture) {
  const double right_angle = 0.5 * std::numbers::pi;
  EXPECT_NEAR(screen_size(1.0, 10.0, right_angle), 0.1, 1e-15);  // two metres of twenty
  EXPECT_EQ(screen_size(1.0, 1.0, right_angle), INFINITY);
  EXPECT_EQ(screen_size(1.0, 0.0, right_angle), INFINITY);
}

/// A character that plays frame by frame.
struct Player {
  Player(const Plan& shown) : plan(shown), held(shown), frame(shown) {}

  const FrameResult& play(std::uint64_t number, UpdateLevel level, std::uint32_t turn = 0, bool asleep = false) {
    const ClipLayer layer{0, kFrame_s * static_cast<double>(number)};
    FrameInput now;
    now.layers = {&layer, 1};
    now.asleep = asleep;
    EXPECT_EQ(run_plan(plan, held.next(now, level, number, turn), frame), ErrorCode::ok);
    return frame.result();
  }

  const Plan& plan;
  HeldInput held;
  FrameBuffer frame;
};

TEST(update_rate, the_finest_level_has_the_bits_and_the_work_of_frames_without_levels) {
  for (std::uint32_t seed = 0; seed < 6; ++seed) {
    const Scene scene = random_scene(seed);
    const Plan plan = compile_plan(lend(scene), {});
    Player player(plan);
    FrameBuffer plain(plan);
    for (std::uint64_t number = 0; number < 12; ++number) {
      const ClipLayer layer{0, kFrame_s * static_cast<double>(number)};
      ASSERT_EQ(run_plan(plan, {.layers = {&layer, 1}, .weights = {}, .root = {}}, plain), ErrorCode::ok);
      const FrameResult& result = player.play(number, UpdateLevel::every, seed);
      EXPECT_EQ(result.work, plain.result().work);
      EXPECT_TRUE(same_bits<Affine>(result.model, plain.result().model));
      for (std::size_t p = 0; p < result.primitives.size(); ++p)
        EXPECT_TRUE(same_bits<glm::vec3>(result.primitives[p].positions, plain.result().primitives[p].positions));
    }
  }
}

TEST(update_rate, P19_frames_between_updates_cost_exactly_nothing) {
  const Scene scene = random_scene(4);
  const Plan plan = compile_plan(lend(scene), {});
  for (const UpdateLevel level : kLevels) {
    Player player(plan);
    player.play(0, level);
    const AllocationCounter counter;
    for (std::uint64_t number = 1; number <= 40; ++number) {
      const FrameResult& result = player.play(number, level);
      EXPECT_EQ(result.work == WorkCounters{}, number % period_of(level) != 0);
      EXPECT_EQ(result.frame, number + 1);
      EXPECT_EQ(result.since_frame, number / period_of(level) * period_of(level) + 1);
    }
    EXPECT_EQ(counter.count(), 0u);
  }
}

TEST(update_rate, what_is_held_is_off_by_no_more_than_its_speed_allows) {
  const Scene scene = arm_scene();  // the tip, one metre away, turns by 90 degrees in a second
  const Plan plan = compile_plan(lend(scene), {});
  for (const UpdateLevel level : kLevels) {
    Player player(plan), exact(plan);
    const double bound_m = 0.5 * std::numbers::pi * static_cast<double>(period_of(level) - 1) * kFrame_s;
    double worst_m = 0.0;
    for (std::uint64_t number = 0; number < 60; ++number) {
      const auto held = player.play(number, level).primitives[0].positions;
      const auto truth = exact.play(number, UpdateLevel::every).primitives[0].positions;
      for (std::size_t v = 0; v < held.size(); ++v)
        worst_m = std::max(worst_m, static_cast<double>(glm::length(held[v] - truth[v])));
    }
    EXPECT_LE(worst_m, bound_m + 1e-6);
    EXPECT_GE(worst_m, 0.95 * bound_m);
  }
}

TEST(update_rate, characters_take_turns) {
  const Scene scene = arm_scene();
  const Plan plan = compile_plan(lend(scene), {});
  std::vector<Player> crowd;
  crowd.reserve(8);
  for (int c = 0; c < 8; ++c) crowd.emplace_back(plan);
  for (std::uint64_t number = 0; number < 12; ++number) {
    int worked = 0;
    for (std::uint32_t c = 0; c < 8; ++c)
      worked += crowd[c].play(number, UpdateLevel::every_fourth, c).work != WorkCounters{};
    EXPECT_EQ(worked, number == 0 ? 8 : 2);
  }
}

TEST(update_rate, who_wakes_up_shows_no_pose_from_before) {
  const Scene scene = arm_scene();
  const Plan plan = compile_plan(lend(scene), {});
  Player player(plan), exact(plan);
  player.play(0, UpdateLevel::every_fourth);
  for (std::uint64_t number = 1; number < 21; ++number) player.play(number, UpdateLevel::every_fourth, 0, true);
  const FrameResult& awake = player.play(21, UpdateLevel::every_fourth);  // the character is not due
  EXPECT_TRUE(same_bits<Affine>(awake.model, exact.play(21, UpdateLevel::every).model));
}

}  // namespace
}  // namespace sinew::test
