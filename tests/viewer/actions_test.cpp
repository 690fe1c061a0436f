// SPDX-License-Identifier: MIT
// The effect of each action on settings and playback.
#include "viewer/app/actions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

#include "tests/viewer/flyer.h"

namespace sinew::viewer {
namespace {

bool changes_settings(Action action) {
  Settings settings;
  return apply(action, settings);
}

bool changes_playback(Action action) {
  const Scene scene = flyer(false);
  Playback playback(scene);
  return apply(action, playback);
}

TEST(actions, of_settings_change_one_thing_each) {
  struct Row {
    Action action;
    std::function<void(Settings&)> change;
  };
  const Row rows[] = {{Action::toggle_ao, [](Settings& s) { s.ambient_occlusion = false; }},
                      {Action::toggle_ao_only, [](Settings& s) { s.show = Show::ao; }},
                      {Action::next_show, [](Settings& s) { s.show = Show::ao; }},
                      {Action::next_ground, [](Settings& s) { s.ground = GroundLook::grid; }},
                      {Action::toggle_skeleton, [](Settings& s) { s.skeleton = true; }},
                      {Action::next_skinning, [](Settings& s) { s.skinning = Skinning::dual_quaternion; }},
                      {Action::next_updates, [](Settings& s) { s.updates = Updates::held; }},
                      {Action::toggle_panel, [](Settings& s) { s.panel = false; }},
                      {Action::toggle_plan, [](Settings& s) { s.plan = true; }},
                      {Action::toggle_keys, [](Settings& s) { s.timeline_keys = true; }},
                      {Action::toggle_inside, [](Settings& s) { s.inside = true; }}};
  for (const Row& row : rows) {
    Settings settings, expected;
    row.change(expected);
    EXPECT_TRUE(apply(row.action, settings));
    EXPECT_TRUE(settings == expected) << static_cast<int>(row.action);
    EXPECT_FALSE(changes_playback(row.action)) << static_cast<int>(row.action);
  }
}

TEST(actions, that_switch_something_switch_it_back) {
  for (const Action action : {Action::toggle_ao, Action::toggle_skeleton, Action::toggle_panel, Action::toggle_plan,
                              Action::toggle_ao_only, Action::toggle_keys, Action::toggle_inside}) {
    Settings settings;
    apply(action, settings);
    EXPECT_FALSE(settings == Settings{}) << static_cast<int>(action);
    apply(action, settings);
    EXPECT_TRUE(settings == Settings{}) << static_cast<int>(action);
  }
}

/// The visible state of playback.
struct Played {
  std::uint32_t clip;
  bool playing;
  double time_s, speed;
  PlayMode mode;

  explicit Played(const Playback& p)
      : clip(p.clip()), playing(p.playing()), time_s(p.time_s()), speed(p.speed()), mode(p.mode()) {}
  bool operator==(const Played&) const = default;
};

TEST(actions, of_playback_do_one_thing_each) {
  Scene scene = flyer(false);
  for (int i = 0; i < 3; ++i) scene.animations.push_back(scene.animations[0]);
  struct Row {
    Action action;
    std::function<void(Played&)> change;
  };
  const Row rows[] = {{Action::toggle_play, [](Played& p) { p.playing = false; }},
                      {Action::step_back,
                       [](Played& p) {
                         p.playing = false;
                         p.time_s = 29.0 / 30.0;
                       }},
                      {Action::step_forward,
                       [](Played& p) {
                         p.playing = false;
                         p.time_s = 31.0 / 30.0;
                       }},
                      {Action::faster, [](Played& p) { p.speed = 1.5; }},
                      {Action::slower, [](Played& p) { p.speed = 0.75; }},
                      {Action::toggle_loop, [](Played& p) { p.mode = PlayMode::ping_pong; }},
                      {Action::next_clip,
                       [](Played& p) {
                         p.clip = 2;
                         p.time_s = 0.0;
                       }},
                      {Action::previous_clip, [](Played& p) {
                         p.clip = 0;
                         p.time_s = 0.0;
                       }}};
  for (const Row& row : rows) {
    Playback playback(scene);
    playback.choose(1);
    playback.seek(1.0);
    Played expected(playback);
    row.change(expected);
    EXPECT_TRUE(apply(row.action, playback));
    EXPECT_NEAR(playback.time_s(), expected.time_s, 1e-12);
    expected.time_s = playback.time_s();
    EXPECT_TRUE(Played(playback) == expected) << static_cast<int>(row.action);
    EXPECT_FALSE(changes_settings(row.action)) << static_cast<int>(row.action);
  }
}

TEST(actions, of_the_window_are_left_to_it) {
  for (const KeyBinding& key : key_bindings()) {
    const bool of_window = key.action == Action::frame_all || key.action == Action::screenshot ||
                           key.action == Action::next_scene || key.action == Action::quit;
    EXPECT_EQ(changes_settings(key.action) || changes_playback(key.action), !of_window) << key.name;
  }
}

}  // namespace
}  // namespace sinew::viewer
