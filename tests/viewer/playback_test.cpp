// SPDX-License-Identifier: MIT
#include "viewer/app/playback.h"

#include <gtest/gtest.h>

#include <cmath>

namespace sinew::viewer {
namespace {

Scene scene_with_clips(std::initializer_list<double> durations_s) {
  Scene scene;
  for (const double duration : durations_s) scene.animations.emplace_back().duration_s = duration;
  return scene;
}

TEST(playback, starts_playing_the_first_clip) {
  const Scene scene = scene_with_clips({2.0, 3.0});
  Playback playback(scene);
  EXPECT_TRUE(playback.playing());
  EXPECT_EQ(playback.clip(), 0u);
  EXPECT_EQ(playback.duration_s(), 2.0);
  playback.advance(0.5);
  ASSERT_EQ(playback.layers().size(), 1u);
  EXPECT_EQ(playback.layers()[0].clip, 0u);
  EXPECT_EQ(playback.layers()[0].time_s, 0.5);
  EXPECT_EQ(playback.layers()[0].weight, 1.0f);
}

TEST(playback, is_as_long_as_what_plays_beside_the_clip) {
  const Scene scene = scene_with_clips({2.0, 3.0}), still;
  Playback beside(scene, 2.5), alone(still, 2.5);
  EXPECT_EQ(beside.duration_s(), 2.5);
  beside.choose(1);
  EXPECT_EQ(beside.duration_s(), 3.0);
  beside.choose(kNone);
  EXPECT_EQ(beside.duration_s(), 2.5);
  alone.advance(1.25);
  EXPECT_EQ(alone.time_s(), 1.25);
  EXPECT_TRUE(alone.layers().empty());
  alone.step(+1);
  EXPECT_NEAR(alone.time_s(), 38.0 / 30.0, 1e-12);
  alone.toggle();
  alone.advance(1.5);
  EXPECT_NEAR(alone.time_s(), 38.0 / 30.0 + 1.5 - 2.5, 1e-12) << "it repeats";
}

TEST(playback, knows_the_frames_to_come) {
  const Scene scene = scene_with_clips({2.0});
  Playback playback(scene);
  playback.advance(0.25);
  EXPECT_EQ(playback.layers_ahead(4)[0].time_s, 1.25);
  EXPECT_EQ(playback.layers_ahead(7)[0].time_s, 0.0) << "around the end";
  EXPECT_EQ(playback.time_s(), 0.25) << "without going there";
  for (int i = 0; i < 4; ++i) playback.advance(0.25);
  EXPECT_EQ(playback.time_s(), 1.25);
  playback.pause();
  EXPECT_EQ(playback.layers_ahead(4)[0].time_s, 1.25);
  playback.choose(kNone);
  EXPECT_TRUE(playback.layers_ahead(4).empty());
}

TEST(playback, a_scene_without_clips_shows_the_rest_pose_and_every_control_is_harmless) {
  const Scene scene;
  Playback playback(scene);
  playback.advance(1.0);
  playback.step(+1);
  playback.step(-1);
  playback.next(+1);
  playback.next(-1);
  playback.seek(3.0);
  playback.choose(7);
  playback.toggle();
  playback.next_mode();
  EXPECT_EQ(playback.clip(), kNone);
  EXPECT_TRUE(playback.layers().empty());
  EXPECT_EQ(playback.time_s(), 0.0);
}

TEST(playback, stands_still_while_paused) {
  const Scene scene = scene_with_clips({2.0});
  Playback playback(scene);
  playback.advance(0.5);
  playback.toggle();
  playback.advance(0.7);
  EXPECT_EQ(playback.time_s(), 0.5);
  playback.toggle();
  playback.advance(0.25);
  EXPECT_EQ(playback.time_s(), 0.75);
}

TEST(playback, repeats_or_turns_back_or_stops_at_the_end) {
  const Scene scene = scene_with_clips({2.0});
  Playback playback(scene);
  playback.advance(2.5);
  EXPECT_EQ(playback.time_s(), 0.5);
  playback.next_mode();
  EXPECT_EQ(playback.mode(), PlayMode::ping_pong);
  EXPECT_EQ(playback.time_s(), 0.5);  // changing the mode keeps the time
  playback.advance(2.0);
  EXPECT_NEAR(playback.time_s(), 1.5, 1e-12);
  playback.next_mode();
  EXPECT_EQ(playback.mode(), PlayMode::once);
  playback.advance(9.0);
  EXPECT_EQ(playback.time_s(), 2.0);
  playback.toggle();  // at the end, play starts again
  EXPECT_TRUE(playback.playing());
  playback.advance(0.5);
  EXPECT_EQ(playback.time_s(), 0.5);
  playback.next_mode();
  EXPECT_EQ(playback.mode(), PlayMode::loop);
}

TEST(playback, plays_all_clips_in_turn_forwards_and_backwards) {
  const Scene scene = scene_with_clips({2.0, 0.0, 3.0});
  Playback playback(scene);
  playback.play_in_turn();
  playback.set_fade(1.0);
  playback.advance(2.25);
  EXPECT_EQ(playback.clip(), 2u) << "a clip without duration is skipped";
  EXPECT_EQ(playback.time_s(), 0.25);
  EXPECT_EQ(playback.moment().faded_clip, 0u);
  EXPECT_EQ(playback.moment().faded_time_s, 2.0) << "it fades out from its end";
  EXPECT_EQ(playback.layers_ahead(9)[0].time_s, 3.0) << "the clip ends, and does not begin again";
  playback.advance(3.0);
  EXPECT_EQ(playback.clip(), 0u);
  EXPECT_EQ(playback.time_s(), 0.25);
  playback.set_speed(-1.0);
  playback.advance(0.75);
  EXPECT_EQ(playback.clip(), 2u);
  EXPECT_EQ(playback.time_s(), 2.5);
  playback.next_mode();
  EXPECT_FALSE(playback.in_turn());
  playback.set_mode(PlayMode::once);
  playback.next_mode();
  EXPECT_TRUE(playback.in_turn());
}

TEST(playback, plays_a_part_of_the_clip) {
  const Scene scene = scene_with_clips({2.0, 3.0});
  Playback playback(scene);
  playback.seek(0.25);
  playback.set_range(1.5, 0.5);
  EXPECT_TRUE(playback.has_range());
  EXPECT_EQ(playback.duration_s(), 2.0);
  EXPECT_EQ(playback.range_start_s(), 0.5);
  EXPECT_EQ(playback.range_end_s(), 1.5);
  EXPECT_EQ(playback.time_s(), 0.5) << "what was outside begins at the start";
  playback.advance(1.25);
  EXPECT_EQ(playback.time_s(), 0.75);
  EXPECT_EQ(playback.layers()[0].time_s, 0.75);
  EXPECT_EQ(playback.layers_ahead(0)[0].time_s, 0.75);
  EXPECT_EQ(playback.moment().turns, 0.0) << "a part does not travel";
  playback.seek(1.75);
  EXPECT_EQ(playback.time_s(), 1.5);
  playback.step(+1);
  EXPECT_NEAR(playback.time_s(), 0.5, 1e-12);
  playback.step(-1);
  EXPECT_NEAR(playback.time_s(), 1.5, 1e-12);
  Playback after(scene);
  after.continue_from(playback, 0);
  EXPECT_EQ(after.range_start_s(), 0.5);
  EXPECT_NEAR(after.time_s(), 1.5, 1e-12);
  playback.set_range(1.0, 1.01);
  EXPECT_FALSE(playback.has_range()) << "shorter than a frame: the whole clip";
  playback.set_range(0.5, 1.5);
  playback.next(+1);
  EXPECT_FALSE(playback.has_range());
}

TEST(playback, starts_again_from_the_end_that_is_behind_it) {
  const Scene scene = scene_with_clips({2.0});
  for (const double speed : {1.0, -1.0}) {
    Playback playback(scene);
    playback.set_mode(PlayMode::once);
    playback.set_speed(speed);
    playback.seek(1.0);
    playback.advance(9.0);
    EXPECT_EQ(playback.time_s(), speed > 0.0 ? 2.0 : 0.0);
    playback.toggle();
    playback.advance(0.5);
    EXPECT_EQ(playback.time_s(), speed > 0.0 ? 0.5 : 1.5);
  }
}

TEST(playback, choosing_a_clip_starts_it_and_keeps_speed_and_mode) {
  const Scene scene = scene_with_clips({2.0, 3.0});
  Playback playback(scene);
  playback.set_speed(2.0);
  playback.set_mode(PlayMode::ping_pong);
  playback.advance(0.5);
  playback.choose(1);
  EXPECT_EQ(playback.time_s(), 0.0);
  EXPECT_EQ(playback.duration_s(), 3.0);
  EXPECT_EQ(playback.speed(), 2.0);
  EXPECT_EQ(playback.mode(), PlayMode::ping_pong);
  playback.choose(kNone);
  EXPECT_TRUE(playback.layers().empty());
  EXPECT_EQ(playback.duration_s(), 0.0);
}

TEST(playback, next_and_previous_go_around_the_ends) {
  const Scene scene = scene_with_clips({1.0, 1.0, 1.0});
  Playback playback(scene);
  playback.next(-1);
  EXPECT_EQ(playback.clip(), 2u);
  playback.next(+1);
  EXPECT_EQ(playback.clip(), 0u);
  playback.next(+1);
  EXPECT_EQ(playback.clip(), 1u);
  playback.choose(kNone);
  playback.next(+1);
  EXPECT_EQ(playback.clip(), 0u);
  playback.choose(kNone);
  playback.next(-1);
  EXPECT_EQ(playback.clip(), 2u);
}

TEST(playback, steps_visit_every_frame_once_in_both_directions) {
  const Scene scene = scene_with_clips({1.0});
  Playback playback(scene);
  for (int frame = 1; frame <= 30; ++frame) {
    playback.step(+1);
    EXPECT_NEAR(playback.time_s(), frame / 30.0, 1e-12);
  }
  EXPECT_FALSE(playback.playing());
  playback.step(+1);
  EXPECT_EQ(playback.time_s(), 0.0);
  playback.step(-1);
  EXPECT_NEAR(playback.time_s(), 1.0, 1e-12);
  for (int frame = 29; frame >= 0; --frame) {
    playback.step(-1);
    EXPECT_NEAR(playback.time_s(), frame / 30.0, 1e-12);
  }
}

TEST(playback, a_step_from_between_two_frames_goes_to_the_next_one) {
  const Scene scene = scene_with_clips({1.0});
  Playback playback(scene);
  playback.seek(10.4 / 30.0);
  playback.step(+1);
  EXPECT_NEAR(playback.time_s(), 11.0 / 30.0, 1e-12);
  playback.seek(10.4 / 30.0);
  playback.step(-1);
  EXPECT_NEAR(playback.time_s(), 10.0 / 30.0, 1e-12);
}

TEST(playback, speeds_have_ends_and_meet_one_again) {
  const Scene scene = scene_with_clips({1.0});
  Playback playback(scene);
  playback.faster();
  EXPECT_GT(playback.speed(), 1.0);
  playback.slower();
  EXPECT_EQ(playback.speed(), 1.0);
  for (int i = 0; i < 40; ++i) playback.faster();
  EXPECT_EQ(playback.speed(), Playback::kFastest);
  for (int i = 0; i < 40; ++i) playback.slower();
  EXPECT_EQ(playback.speed(), Playback::kSlowest);
  playback.set_speed(1.2);
  playback.faster();
  EXPECT_EQ(playback.speed(), 1.5);
}

TEST(playback, goes_on_from_another_one_in_a_clip_of_another_scene) {
  const Scene before = scene_with_clips({2.0, 3.0}), now = scene_with_clips({1.0, 5.0, 3.5});
  Playback old(before);
  old.choose(1);
  old.set_mode(PlayMode::once);
  old.set_speed(-0.5);
  old.seek(2.25);
  old.pause();
  Playback playback(now);
  playback.continue_from(old, 2);
  EXPECT_EQ(playback.clip(), 2u);
  EXPECT_EQ(playback.time_s(), 2.25);
  EXPECT_EQ(playback.duration_s(), 3.5);
  EXPECT_EQ(playback.speed(), -0.5);
  EXPECT_EQ(playback.mode(), PlayMode::once);
  EXPECT_FALSE(playback.playing());
  playback.continue_from(old, 0);
  EXPECT_EQ(playback.time_s(), 1.0) << "the clip is shorter";
  playback.continue_from(old, kNone);
  EXPECT_EQ(playback.clip(), kNone);
}

TEST(playback, begins_the_first_clip_where_the_one_before_is_gone) {
  const Scene before = scene_with_clips({2.0, 3.0}), now = scene_with_clips({1.0});
  Playback old(before), playback(now);
  old.set_speed(2.0);
  old.seek(0.5);
  playback.continue_from(old, std::nullopt);
  EXPECT_EQ(playback.clip(), 0u);
  EXPECT_EQ(playback.time_s(), 0.0);
  EXPECT_EQ(playback.duration_s(), 1.0);
  EXPECT_EQ(playback.speed(), 2.0);
  EXPECT_TRUE(playback.playing());
}

TEST(playback, there_and_back_goes_on_in_its_direction) {
  const Scene before = scene_with_clips({2.0}), now = scene_with_clips({3.0}), shorter_scene = scene_with_clips({1.0});
  for (const double speed : {1.0, -0.5, 0.0}) {
    Playback old(before), playback(now);
    old.set_mode(PlayMode::ping_pong);
    old.advance(2.5);  // 1.5 on the way back
    old.set_speed(speed);
    playback.continue_from(old, 0);
    EXPECT_EQ(playback.time_s(), 1.5) << speed;
    EXPECT_EQ(playback.speed(), speed);
    playback.advance(0.5);
    EXPECT_EQ(playback.time_s(), 1.5 - 0.5 * speed) << "on the way back, the time goes down";
    Playback shorter(shorter_scene);
    shorter.continue_from(old, 0);
    EXPECT_EQ(shorter.time_s(), 1.0) << "at its end";
    shorter.advance(0.25);
    EXPECT_EQ(shorter.time_s(), 1.0 - 0.25 * std::abs(speed)) << "and it turns there";
  }
}

}  // namespace
}  // namespace sinew::viewer
