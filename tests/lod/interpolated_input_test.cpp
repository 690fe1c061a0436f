// SPDX-License-Identifier: MIT
#include "runtime/lod/interpolated_input.h"

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

std::uint32_t period_of(UpdateLevel level) { return 1u << static_cast<unsigned>(level); }

Plan plan_between(const Scene& scene) {
  Needs needs;
  needs.in.between_updates = true;
  return compile_plan(lend(scene), needs);
}

/// A character that plays clip 0 in frames of `frame_s`.
struct Player {
  Player(const Plan& shown, double frame) : plan(shown), input(shown), buffer(shown), frame_s(frame) {}

  ClipLayer layer_at(std::uint64_t number) const { return {clip, frame_s * static_cast<double>(number)}; }

  const FrameResult& play(std::uint64_t number, UpdateLevel level, std::uint32_t turn = 0, bool asleep = false) {
    const ClipLayer layer = layer_at(number), ahead = layer_at(number + frames_to_update(level, number, turn));
    FrameInput now;
    now.layers = {&layer, 1};
    now.asleep = asleep;
    EXPECT_EQ(run_plan(plan, input.next(now, {&ahead, 1}, level, number, turn), buffer), ErrorCode::ok);
    return buffer.result();
  }

  const Plan& plan;
  InterpolatedInput input;
  FrameBuffer buffer;
  double frame_s;
  std::uint32_t clip = 0;
};

double farthest_apart(const FrameResult& a, const FrameResult& b) {
  double worst = 0.0;
  for (std::size_t p = 0; p < a.primitives.size(); ++p)
    for (std::size_t v = 0; v < a.primitives[p].positions.size(); ++v)
      worst = std::max(worst,
                       static_cast<double>(glm::length(a.primitives[p].positions[v] - b.primitives[p].positions[v])));
  return worst;
}

TEST(interpolated_input, frames_are_counted_to_the_next_turn) {
  for (const UpdateLevel level : kLevels)
    for (std::uint64_t frame = 0; frame < 20; ++frame)
      for (std::uint32_t turn = 0; turn < 5; ++turn) {
        const std::uint32_t left = frames_to_update(level, frame, turn);
        EXPECT_TRUE(left >= 1 && left <= period_of(level));
        EXPECT_EQ((frame + left + turn) % period_of(level), 0u);
      }
}

TEST(interpolated_input, N27_the_finest_level_has_the_bits_of_frames_without_levels) {
  const Scene scene = random_scene(3);
  const Plan plan = plan_between(scene), plain = compile_plan(lend(scene), {});
  Player player(plan, 1.0 / 60.0);
  FrameBuffer expected(plain);
  for (std::uint64_t number = 0; number < 12; ++number) {
    const ClipLayer layer = player.layer_at(number);
    ASSERT_EQ(run_plan(plain, {.layers = {&layer, 1}, .weights = {}, .root = {}}, expected), ErrorCode::ok);
    EXPECT_TRUE(same_bits<Affine>(player.play(number, UpdateLevel::every).model, expected.result().model));
  }
}

TEST(interpolated_input, P19_sampling_costs_the_share_of_the_level) {
  const Scene scene = random_scene(4);
  const Plan plan = plan_between(scene);
  const std::uint64_t tracks = plan.clip_tracks()[0].joints + plan.clip_tracks()[0].weights;
  for (const UpdateLevel level : kLevels) {
    Player player(plan, 1.0 / 60.0);
    player.play(0, level);
    const AllocationCounter counter;
    std::uint64_t sampled = 0;
    for (std::uint64_t number = 1; number <= 40; ++number) sampled += player.play(number, level).work.tracks_sampled;
    EXPECT_EQ(sampled, 40 / period_of(level) * tracks);
    EXPECT_EQ(counter.count(), 0u);
  }
}

TEST(interpolated_input, at_updates_nothing_lags_and_nothing_is_off) {
  const Scene scene = random_scene(5);
  const Plan plan = plan_between(scene);
  Player player(plan, 1.0 / 60.0), exact(plan, 1.0 / 60.0);
  for (std::uint64_t number = 0; number < 24; ++number) {
    const FrameResult &shown = player.play(number, UpdateLevel::every_fourth),
                      &truth = exact.play(number, UpdateLevel::every);
    EXPECT_EQ(same_bits<Affine>(shown.model, truth.model), number % 4 == 0) << number;
  }
}

/// The largest distance from the full-rate result over 60 frames.
double error_of(const Scene& scene, UpdateLevel level, double frame_s) {
  const Plan plan = plan_between(scene);
  Player player(plan, frame_s), exact(plan, frame_s);
  double worst = 0.0;
  for (std::uint64_t number = 0; number < 60; ++number)
    worst = std::max(worst, farthest_apart(player.play(number, level), exact.play(number, UpdateLevel::every)));
  return worst;
}

TEST(interpolated_input, N04_what_turns_evenly_is_off_by_the_cube_of_its_angle) {
  const Scene scene = arm_scene();  // the tip, one metre away, turns by 90 degrees in a second
  for (const UpdateLevel level : {UpdateLevel::every_second, UpdateLevel::every_fourth}) {
    const double frame_s = 1.0 / 12.0, angle = 0.5 * std::numbers::pi * frame_s * period_of(level);
    const double worst = error_of(scene, level, frame_s), bound = 0.0041 * angle * angle * angle;
    EXPECT_LE(worst, bound + 1e-6);
    if (level == UpdateLevel::every_fourth) {
      EXPECT_GE(worst, 0.8 * bound);
    }  // halfway the chord has the exact angle
  }
}

TEST(interpolated_input, what_accelerates_is_off_by_an_eighth_of_it_times_the_square_of_the_interval) {
  Scene scene = arm_scene();
  constexpr float kAcceleration = 8.0f;  // x = 4 t^2, which a cubic represents exactly
  BoneAnimation bone;
  bone.joint = 2;
  bone.translation = {Interpolation::cubic_spline,
                      {0.0f, 1.0f},
                      {glm::vec3(0), glm::vec3(0, 1, 0), glm::vec3(0), glm::vec3(kAcceleration, 0, 0),
                       glm::vec3(0.5f * kAcceleration, 1, 0), glm::vec3(0)}};
  scene.animations[0].bones = {bone};
  scene.clips.clear();
  finish_scene(scene);
  for (const UpdateLevel level : {UpdateLevel::every_second, UpdateLevel::every_fourth}) {
    const double frame_s = 1.0 / 60.0, interval_s = frame_s * period_of(level);
    const double bound = static_cast<double>(kAcceleration) * interval_s * interval_s / 8.0;
    const double worst = error_of(scene, level, frame_s);
    EXPECT_LE(worst, bound + 1e-6);
    EXPECT_GE(worst, 0.99 * bound);
  }
}

TEST(interpolated_input, is_far_nearer_than_what_is_held) {
  for (std::uint32_t seed = 0; seed < 4; ++seed) {
    const Scene scene = random_scene(seed);
    const Plan plan = plan_between(scene);
    Player player(plan, 1.0 / 60.0), exact(plan, 1.0 / 60.0);
    HeldInput held(plan);
    FrameBuffer holding(plan);
    double of_interpolated = 0.0, of_held = 0.0;
    for (std::uint64_t number = 0; number < 60; ++number) {
      const ClipLayer layer = player.layer_at(number);
      FrameInput now;
      now.layers = {&layer, 1};
      ASSERT_EQ(run_plan(plan, held.next(now, UpdateLevel::every_fourth, number, 0), holding), ErrorCode::ok);
      const FrameResult& truth = exact.play(number, UpdateLevel::every);
      of_held += farthest_apart(holding.result(), truth);
      of_interpolated += farthest_apart(player.play(number, UpdateLevel::every_fourth), truth);
    }
    EXPECT_LT(of_interpolated, 0.5 * of_held) << "seed " << seed << ": step tracks are among them";
  }
}

TEST(interpolated_input, another_clip_shows_from_the_next_update_on_without_a_jump) {
  const Scene scene = random_scene(6);
  const Plan plan = plan_between(scene);
  Player player(plan, 1.0 / 60.0), exact(plan, 1.0 / 60.0);
  for (std::uint64_t number = 0; number < 8; ++number) player.play(number, UpdateLevel::every_fourth);
  const FrameResult& last = player.play(8, UpdateLevel::every_fourth);
  EXPECT_TRUE(same_bits<Affine>(last.model, exact.play(8, UpdateLevel::every).model));
  player.clip = exact.clip = 1;
  for (std::uint64_t number = 9; number < 12; ++number) player.play(number, UpdateLevel::every_fourth);
  const ClipLayer promised{0, player.frame_s * 12};
  FrameBuffer alone(plan);
  ASSERT_EQ(run_plan(plan, {.layers = {&promised, 1}, .weights = {}, .root = {}}, alone), ErrorCode::ok);
  EXPECT_TRUE(same_bits<Affine>(player.play(12, UpdateLevel::every_fourth).model, alone.result().model));
  for (std::uint64_t number = 13; number < 16; ++number) player.play(number, UpdateLevel::every_fourth);
  EXPECT_TRUE(
      same_bits<Affine>(player.play(16, UpdateLevel::every_fourth).model, exact.play(16, UpdateLevel::every).model));
}

TEST(interpolated_input, after_a_cut_or_a_sleep_nothing_of_before_shows) {
  const Scene scene = random_scene(6);
  const Plan plan = plan_between(scene);
  Player player(plan, 1.0 / 60.0), exact(plan, 1.0 / 60.0);
  const auto expect_exact = [&](std::uint64_t number) {
    EXPECT_TRUE(same_bits<Affine>(player.play(number, UpdateLevel::every_fourth).model,
                                  exact.play(number, UpdateLevel::every).model))
        << number;
  };
  for (std::uint64_t number = 0; number < 6; ++number) player.play(number, UpdateLevel::every_fourth);
  player.input.restart();
  expect_exact(6);  // the character is not due
  expect_exact(8);
  player.play(9, UpdateLevel::every_fourth);
  EXPECT_TRUE(player.play(10, UpdateLevel::every_fourth, 0, true).model.empty());
  expect_exact(11);
  player.play(12, UpdateLevel::every_fourth);
  player.play(13, UpdateLevel::every_fourth);
  expect_exact(30);  // frame numbers were skipped
  player.play(32, UpdateLevel::every_fourth);
  expect_exact(7);  // the frame number went back
}

TEST(interpolated_input, levels_change_where_an_interval_ends) {
  const Scene scene = random_scene(7);
  const Plan plan = plan_between(scene);
  Player player(plan, 1.0 / 60.0), exact(plan, 1.0 / 60.0);
  player.play(0, UpdateLevel::every_fourth);
  player.play(1, UpdateLevel::every);
  for (std::uint64_t number = 0; number < 20; ++number) {
    const UpdateLevel level = number < 2    ? UpdateLevel::every_fourth
                              : number < 10 ? UpdateLevel::every
                                            : UpdateLevel::every_second;
    const bool is_exact =
        same_bits<Affine>(player.play(number, level).model, exact.play(number, UpdateLevel::every).model);
    EXPECT_EQ(is_exact, number == 0 || (number >= 4 && number < 10) || (number >= 10 && number % 2 == 0)) << number;
  }
}

TEST(interpolated_input, the_root_is_always_of_this_frame) {
  const Scene scene = arm_scene();
  const Plan plan = plan_between(scene);
  InterpolatedInput input(plan);
  const ClipLayer layer{0, 0.0}, ahead{0, 0.1};
  FrameInput now;
  now.layers = {&layer, 1};
  for (std::uint64_t number = 0; number < 6; ++number) {
    now.root.row[0].w = static_cast<float>(number);
    EXPECT_EQ(input.next(now, {&ahead, 1}, UpdateLevel::every_fourth, number, 0).root, now.root);
  }
}

}  // namespace
}  // namespace sinew::test
