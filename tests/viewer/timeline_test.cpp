// SPDX-License-Identifier: MIT
#include "viewer/app/panel/timeline_panel.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <cmath>

#include <gtest/gtest.h>

#include "tests/viewer/imgui_fixture.h"
#include "viewer/app/timeline/channels.h"

namespace sinew::viewer {
namespace {

/// Two joints: the first turns a quarter about z in a second and rises, the second rests.
Scene turning() {
  Scene scene;
  scene.skeleton.parents = {kNone, 0};
  scene.skeleton.rest.resize(2);
  scene.skeleton.rest[1].translation = {1, 2, 3};
  scene.skeleton.names = {"hip", ""};
  Animation& animation = scene.animations.emplace_back();
  animation.duration_s = 2.0;
  BoneAnimation& bone = animation.bones.emplace_back();
  const float c = std::sqrt(0.5f);
  bone.rotation = {Interpolation::linear, {0.0f, 1.0f, 2.0f}, {{1, 0, 0, 0}, {c, 0, 0, c}, {1, 0, 0, 0}}};
  bone.translation = {Interpolation::step, {0.0f, 1.5f}, {{0, 0, 0}, {0, 4, 0}}};
  scene.instances.emplace_back();
  scene.meshes.emplace_back().name = "face";
  animation.weights.push_back({0, {Interpolation::linear, {0.25f}, {1.0f}, 1}, 0});
  animation.properties.push_back({{PropertyKind::node_visible, 1}, {Interpolation::step, {1.0f}, {0.0f}, 1}});
  scene.animations.emplace_back().duration_s = 3.0;
  return scene;
}

TEST(timeline, has_a_channel_for_each_track) {
  const Scene scene = turning();
  const auto channels = channels_of(scene, 0);
  ASSERT_EQ(channels.size(), 4u);
  EXPECT_EQ(channel_label(scene, 0, channels[0]), "hip position");
  EXPECT_EQ(channel_label(scene, 0, channels[1]), "hip rotation");
  EXPECT_EQ(channel_label(scene, 0, channels[2]), "face morph targets");
  EXPECT_EQ(channel_label(scene, 0, channels[3]), "property 0") << "its joint has no name";
  EXPECT_EQ(joint_label(scene, 1), "joint 1");
  EXPECT_EQ(all_key_times(channels), (std::vector<float>{0.0f, 0.25f, 1.0f, 1.5f, 2.0f}));
  EXPECT_TRUE(channels_of(scene, 1).empty());
  EXPECT_TRUE(channels_of(scene, kNone).empty());
}

TEST(timeline, curves_are_what_the_clip_says_between_its_keys) {
  const Scene scene = turning();
  EXPECT_NEAR(curve_value(scene, 0, 0, ChannelKind::rotation, 0.5).z, 45.0, 1e-4);
  EXPECT_NEAR(curve_value(scene, 0, 0, ChannelKind::rotation, 1.0).z, 90.0, 1e-4);
  EXPECT_EQ(curve_value(scene, 0, 0, ChannelKind::position, 1.4).y, 0.0);
  EXPECT_EQ(curve_value(scene, 0, 0, ChannelKind::position, 1.6).y, 4.0);
  EXPECT_EQ(curve_value(scene, 0, 1, ChannelKind::position, 0.5), glm::dvec3(1, 2, 3)) << "a joint without keys rests";
  EXPECT_EQ(curve_value(scene, kNone, 1, ChannelKind::scale, 0.5), glm::dvec3(1.0));
}

TEST(timeline, the_marks_of_a_ruler_are_round_and_far_enough_apart) {
  EXPECT_NEAR(ruler_step(0.003, 0.001), 0.005, 1e-15);
  EXPECT_NEAR(ruler_step(0.3, 0.001), 0.5, 1e-12);
  EXPECT_NEAR(ruler_step(0.00001, 0.001), 0.001, 1e-15);
  EXPECT_NEAR(ruler_step(1.1, 0.001), 2.0, 1e-12);
}

class TimelinePanel : public ImguiTest {
 protected:
  TimelinePanel() { facts_.scene = &scene_; }

  FreePart frame() {
    ImGui::NewFrame();
    const FreePart free = lay_out_timeline(facts_, settings_, playback_, {});
    ImGui::Render();
    return free;
  }

  /// Puts the mouse over an item of the timeline, or of a list that is open.
  void hover(const char* label, const char* window_name = "timeline", const int* number = nullptr) {
    frame();
    frame();
    const ImGuiWindow* window = ImGui::FindWindowByName(window_name);
    ASSERT_NE(window, nullptr);
    const ImGuiID id =
        number ? ImHashStr(label, 0, ImHashData(number, sizeof *number, window->ID)) : ImHashStr(label, 0, window->ID);
    for (float y = window->Pos.y; y < window->Pos.y + window->Size.y && context_->HoveredId != id; y += 4)
      for (float x = window->Pos.x; x < window->Pos.x + window->Size.x && context_->HoveredId != id; x += 6) {
        ImGui::GetIO().MousePos = {x, y};
        frame();
      }
    ASSERT_EQ(context_->HoveredId, id) << label << " is nowhere";
  }

  void press_and_release(int button, float to_x) {
    ImGui::GetIO().MouseDown[button] = true;
    frame();
    ImGui::GetIO().MousePos.x = to_x;
    frame();
    ImGui::GetIO().MouseDown[button] = false;
    frame();
  }

  void click(const char* label, const char* window = "timeline", const int* number = nullptr) {
    hover(label, window, number);
    press_and_release(0, ImGui::GetIO().MousePos.x);
  }

  Scene scene_ = turning();
  PanelFacts facts_;
  Settings settings_;
  Playback playback_{scene_};
};

TEST_F(TimelinePanel, plays_pauses_and_steps) {
  click("pause##play");
  EXPECT_FALSE(playback_.playing());
  click("play##play");
  EXPECT_TRUE(playback_.playing());
  click(">##step");
  EXPECT_NEAR(playback_.time_s(), 1.0 / 30.0, 1e-12);
  click("<##step");
  EXPECT_EQ(playback_.time_s(), 0.0);
}

TEST_F(TimelinePanel, the_ruler_goes_to_a_time_and_chooses_what_plays) {
  hover("time");
  press_and_release(0, 1279.0f);
  EXPECT_EQ(playback_.time_s(), 2.0);
  EXPECT_FALSE(playback_.playing());
  hover("time");
  press_and_release(0, 0.0f);
  EXPECT_EQ(playback_.time_s(), 0.0);
  hover("time");
  press_and_release(1, 640.0f);
  EXPECT_TRUE(playback_.has_range());
  EXPECT_NEAR(playback_.range_end_s(), 1.0, 0.02);
  hover("time");
  press_and_release(1, ImGui::GetIO().MousePos.x);
  EXPECT_FALSE(playback_.has_range());
}

TEST_F(TimelinePanel, speed_has_a_slider_and_a_sign) {
  hover("##speed");
  press_and_release(0, 1279.0f);
  EXPECT_EQ(playback_.speed(), 4.0);
  hover("##speed");
  press_and_release(0, 0.0f);
  EXPECT_EQ(playback_.speed(), -2.0);
  hover("##speed");
  press_and_release(1, ImGui::GetIO().MousePos.x);
  EXPECT_EQ(playback_.speed(), 1.0) << "by a right click";
  click("backwards");
  EXPECT_EQ(playback_.speed(), -1.0);
}

TEST_F(TimelinePanel, the_way_of_playing_is_chosen_from_a_list) {
  for (const auto& [name, mode] :
       {std::pair{"once", PlayMode::once}, {"there and back", PlayMode::ping_pong}, {"repeat", PlayMode::loop}}) {
    click("##loop");
    click(name, "##Combo_00");
    EXPECT_EQ(playback_.mode(), mode) << name;
  }
  click("##loop");
  click("all clips in turn", "##Combo_00");
  EXPECT_TRUE(playback_.in_turn());
}

TEST_F(TimelinePanel, grows_by_rows_of_keys_and_by_the_curve_of_a_joint) {
  const auto height = [&] {
    for (int i = 0; i < 3; ++i) frame();
    return ImGui::FindWindowByName("timeline")->Size.y;
  };
  const float folded = height();
  const FreePart free = frame();
  EXPECT_NEAR(free.bottom, 2.0 * static_cast<double>(folded + 6.5f) / 720.0 - 1.0, 0.01) << "the camera stays above";
  click("keys");
  const float with_rows = height();
  EXPECT_GT(with_rows, folded + 60.0f);
  settings_.inspected.joint = 0;
  EXPECT_GT(height(), with_rows + 50.0f);
  facts_.scene = &scene_;
  playback_.choose(1);
  EXPECT_EQ(height(), folded) << "this clip has no tracks";
}

TEST_F(TimelinePanel, is_not_there_without_time) {
  const Scene still;
  facts_.scene = &still;
  Playback none(still);
  ImGui::NewFrame();
  EXPECT_EQ(lay_out_timeline(facts_, settings_, none, {-0.5, 1.0}), (FreePart{-0.5, 1.0}));
  ImGui::Render();
  EXPECT_EQ(ImGui::FindWindowByName("timeline"), nullptr);
}

}  // namespace
}  // namespace sinew::viewer
