// SPDX-License-Identifier: MIT
// Every text of the panels, and the position of the live plan. Uses ImGui's logging.
#include <imgui.h>
#include <imgui_internal.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/viewer/imgui_fixture.h"
#include "viewer/app/keys.h"
#include "viewer/app/panel/inspect_panel.h"
#include "viewer/app/panel/panel.h"
#include "viewer/app/panel/plan_panel.h"
#include "viewer/app/panel/timeline_panel.h"

namespace sinew::viewer {
namespace {

using testing::HasSubstr;
using testing::Not;

class PanelText : public ImguiTest {
 protected:
  PanelText() {
    for (const char* name : {"walk", "run", ""}) {
      Animation& animation = scene_.animations.emplace_back();
      animation.name = name;
      animation.duration_s = 2.0;
    }
    facts_.name = "knight.glb";
    facts_.scene = &scene_;
    facts_.needs = &needs_;
  }

  /// The text of a window, after some frames in which it finds its size. ImGui puts the log on the clipboard when the
  /// window ends.
  template <class LayOut>
  std::string logged(const LayOut& lay_out) {
    std::string text;
    ImGui::GetIO().ClipboardUserData = &text;
    ImGui::GetIO().SetClipboardTextFn = [](void* to, const char* log) { *static_cast<std::string*>(to) = log; };
    for (int frame = 0; frame < 3; ++frame) {
      text.clear();
      ImGui::NewFrame();
      ImGui::LogToClipboard();
      lay_out();
      ImGui::Render();
    }
    return text;
  }
  std::string written(Playback& playback) {
    return logged([&] { lay_out_panel(facts_, settings_, playback); });
  }
  std::string plan_written() {
    return logged([&] {
      bool open = true;
      lay_out_plan(facts_, open);
    });
  }
  std::string written() {
    Playback playback(scene_);
    return written(playback);
  }

  const ImGuiWindow& plan_window() {
    const ImGuiWindow* window = ImGui::FindWindowByName("live plan (e hides this)");
    EXPECT_NE(window, nullptr);
    return *window;
  }

  Scene scene_;
  Needs needs_;
  PanelFacts facts_;
  Settings settings_;
};

TEST_F(PanelText, time_is_that_of_the_playback_and_its_length) {
  Playback playback(scene_);
  playback.seek(0.5);
  const auto timeline = [&] { return logged([&] { lay_out_timeline(facts_, settings_, playback, {}); }); };
  EXPECT_THAT(timeline(), HasSubstr("0.500 / 2.000 s"));
  EXPECT_THAT(timeline(), HasSubstr("pause"));
  playback.pause();
  EXPECT_THAT(timeline(), Not(HasSubstr("pause")));
  EXPECT_THAT(timeline(), HasSubstr("play"));
  EXPECT_THAT(timeline(), HasSubstr("repeat"));
  playback.set_mode(PlayMode::ping_pong);
  EXPECT_THAT(timeline(), HasSubstr("there and back"));
  playback.set_mode(PlayMode::clamp);
  EXPECT_THAT(timeline(), HasSubstr("hold the end"));
  playback.play_in_turn();
  EXPECT_THAT(timeline(), HasSubstr("all clips in turn"));
  settings_.counts_frames = true;
  EXPECT_THAT(timeline(), HasSubstr("15.0 / 60.0 frames"));
}

TEST_F(PanelText, what_is_inspected_has_numbers) {
  scene_.skeleton.parents = {kNone, 0};
  scene_.skeleton.rest.resize(2);
  scene_.skeleton.names = {"hip", "knee"};
  scene_.lights.emplace_back().joint = 1;
  Affine world[2];
  world[0].row[0].w = 1.0f;
  world[1].row[0].w = 1.5f;
  FrameResult pose;
  pose.model = world;
  facts_.pose = &pose;
  const auto inside = [&] { return logged([&] { lay_out_inspect(facts_, settings_, {}); }); };
  EXPECT_THAT(inside(), Not(HasSubstr("hip"))) << "it is closed";
  settings_.inside = true;
  EXPECT_THAT(inside(), testing::AllOf(HasSubstr("hip"), HasSubstr("knee"), Not(HasSubstr("position"))));
  settings_.inspected.joint = 1;
  EXPECT_THAT(inside(), HasSubstr("knee: joint 1"));
  EXPECT_THAT(inside(), HasSubstr("light"));
  EXPECT_THAT(inside(), testing::ContainsRegex("position +0.5 +0 +0 m"));
  EXPECT_THAT(inside(), testing::ContainsRegex("in world +1.5 +0 +0 m"));
  FreePart free;
  logged([&] { free = lay_out_inspect(facts_, settings_, {}); });
  EXPECT_LT(free.right, 0.6) << "the picture is beside it";
}

TEST_F(PanelText, the_clip_that_plays_is_named) {
  Playback playback(scene_);
  EXPECT_THAT(written(playback), HasSubstr("walk"));
  playback.choose(1);
  EXPECT_THAT(written(playback), HasSubstr("run"));
  EXPECT_THAT(written(playback), Not(HasSubstr("walk")));
}

TEST_F(PanelText, without_clips_it_says_so_and_has_no_controls_of_time) {
  scene_ = Scene{};
  const std::string text = written();
  EXPECT_THAT(text, HasSubstr("no clips: the rest pose is shown"));
  EXPECT_THAT(text, Not(HasSubstr(" s\n")));
  EXPECT_THAT(text, Not(HasSubstr("play")));
  EXPECT_THAT(text, Not(HasSubstr("updates")));
  scene_.animations.emplace_back().duration_s = 1.0;
  EXPECT_THAT(written(), Not(HasSubstr("no clips")));
}

TEST_F(PanelText, the_file_is_named_or_the_scenes_are_offered) {
  facts_.note = "two left feet";
  EXPECT_THAT(written(), HasSubstr("knight.glb"));
  EXPECT_THAT(written(), HasSubstr("two left feet"));
  const std::vector<std::string> names{"arm", "flag"};
  facts_.scene_names = names;
  facts_.scene_index = 1;
  EXPECT_THAT(written(), HasSubstr("flag"));
  EXPECT_THAT(written(), Not(HasSubstr("knight.glb")));
  EXPECT_THAT(written(), Not(HasSubstr("arm")));
  facts_.scene_names = std::span(names).first(1);
  facts_.scene_index = 0;
  EXPECT_THAT(written(), HasSubstr("knight.glb")) << "one is no choice";
}

TEST_F(PanelText, warnings_are_counted_on_a_badge) {
  EXPECT_THAT(written(), Not(HasSubstr("warning")));
  const std::vector<std::string> messages{"walk.glb has no tail", "no light"};
  facts_.messages = std::span(messages).first(1);
  EXPECT_THAT(written(), HasSubstr("### 1 warning ###"));
  facts_.messages = messages;
  EXPECT_THAT(written(), HasSubstr("### 2 warnings ###"));
  EXPECT_THAT(written(), Not(HasSubstr("no tail"))) << "the list is folded";
}

TEST_F(PanelText, morph_targets_can_be_set_by_hand_where_there_are_some) {
  EXPECT_THAT(written(), Not(HasSubstr("morph targets")));
  scene_.meshes.emplace_back().default_weights = {0.0f, 0.0f};
  scene_.instances.emplace_back().rest_weights = {0.25f, 0.5f};
  scene_.first_weight = {0, 2};
  EXPECT_THAT(written(), HasSubstr("### morph targets ###"));
}

TEST_F(PanelText, why_a_changed_file_is_not_shown_stands_below_its_name) {
  EXPECT_THAT(written(), Not(HasSubstr("changed")));
  facts_.reload_fault = "knight.glb: error: glb-length";
  EXPECT_THAT(written(), HasSubstr("changed, and shown as before:"));
  EXPECT_THAT(written(), HasSubstr("knight.glb: error: glb-length"));
}

TEST_F(PanelText, skinning_is_offered_where_there_are_skins_and_the_scene_does_not_choose) {
  EXPECT_THAT(written(), Not(HasSubstr("dual quaternion")));
  scene_.skins.emplace_back();
  EXPECT_THAT(written(), HasSubstr("linear blend"));
  EXPECT_THAT(written(), HasSubstr("dual quaternion"));
  EXPECT_THAT(written(), HasSubstr("center of rotation"));
  for (const auto& [skinning, name] : {std::pair{Skinning::linear, "(x) linear blend"},
                                       {Skinning::dual_quaternion, "(x) dual quaternion"},
                                       {Skinning::center_of_rotation, "(x) center of rotation"}}) {
    settings_.skinning = skinning;
    const std::string text = written(), choices = text.substr(0, text.find("occlusion"));
    EXPECT_THAT(choices, HasSubstr(name));
    EXPECT_EQ(choices.find("(x)"), choices.rfind("(x)")) << "one is chosen";
  }
  needs_.skin.per_instance = {Skinning::linear};
  EXPECT_THAT(written(), HasSubstr("skinning: the scene chooses for each mesh"));
  EXPECT_THAT(written(), Not(HasSubstr("dual quaternion")));
}

TEST_F(PanelText, cameras_and_variants_are_offered_where_there_are_some) {
  EXPECT_THAT(written(), Not(HasSubstr("camera")));
  EXPECT_THAT(written(), Not(HasSubstr("variant")));
  scene_.cameras.emplace_back().name = "nowhere";
  EXPECT_THAT(written(), Not(HasSubstr("camera"))) << "no node places it";
  scene_.cameras.emplace_back().joint = 0;
  scene_.cameras[1].name = "close up";
  scene_.variants = {"red", "blue"};
  settings_.camera = 1;
  settings_.variant = 1;
  EXPECT_THAT(written(), HasSubstr("camera"));
  EXPECT_THAT(written(), HasSubstr("close up"));
  EXPECT_THAT(written(), HasSubstr("blue"));
  EXPECT_THAT(written(), Not(HasSubstr("red"))) << "the list is closed";
}

TEST_F(PanelText, why_poses_are_evaluated_as_often_as_they_are) {
  facts_.updates = "every frame: it fills the picture";
  EXPECT_THAT(written(), HasSubstr("every frame: it fills the picture"));
}

TEST_F(PanelText, a_cache_says_its_name_frames_and_faults) {
  EXPECT_THAT(written(), Not(HasSubstr("vertices")));
  facts_.cache.emplace();
  facts_.cache->name = "flag.sgeo";
  facts_.cache->frame_count = 150;
  facts_.cache->frame_s = 0.04;
  facts_.cache->vertex_count = 29949;
  EXPECT_THAT(written(), HasSubstr("flag.sgeo"));
  EXPECT_THAT(written(), HasSubstr("150 frames of 40.0 ms, 29949 vertices"));
  EXPECT_THAT(written(), HasSubstr((describe_window(*facts_.cache)).substr(0, 20)));
  facts_.cache->fault = "cache-checksum";
  EXPECT_THAT(written(), HasSubstr("cache-checksum"));
}

PlanRow row(PlanPart part, const char* stage, bool runs, std::uint64_t count, std::uint32_t timed, double time_us) {
  return {.part = part,
          .stage = stage,
          .runs = runs,
          .reason = runs ? "it is needed" : "nobody asks",
          .count = count,
          .timed = timed,
          .time_us = time_us};
}

TEST_F(PanelText, the_live_plan_has_a_row_for_each_stage_and_a_title_for_each_part) {
  facts_.device = "llvmpipe";
  facts_.frame_ms = 16.65;
  const PlanRow rows[] = {row(PlanPart::evaluation, "sample", true, 12345, 1, 3.25),
                          row(PlanPart::evaluation, "blend", false, 777, 0, 8.5),
                          row(PlanPart::passes, "opaque", true, 9, 0, 6.5)};
  facts_.rows = rows;
  const std::string text = plan_written();
  for (const char* shown : {"llvmpipe", "16.6 ms from picture to picture", "sample", "blend", "opaque", "12345", "3.2",
                            "it is needed", "nobody asks"})
    EXPECT_THAT(text, HasSubstr(shown));
  EXPECT_THAT(text, Not(HasSubstr("777"))) << "a stage that does not run counts nothing";
  EXPECT_THAT(text, Not(HasSubstr("8.5"))) << "what was not timed has no time";
  EXPECT_THAT(text, Not(HasSubstr("6.5")));
  EXPECT_THAT(text, Not(HasSubstr("nothing moves")));
  for (const PlanPart part : {PlanPart::evaluation, PlanPart::passes}) {
    const std::string title(title_of(part));
    const std::size_t at = text.find(title);
    ASSERT_NE(at, std::string::npos) << title;
    EXPECT_EQ(text.find(title, at + 1), std::string::npos) << "once";
    EXPECT_EQ(at < text.find("sample"), part == PlanPart::evaluation);
    EXPECT_LT(at, text.find("opaque"));
  }
  facts_.resting = true;
  EXPECT_THAT(plan_written(), HasSubstr("nothing moves: no pose is evaluated"));
}

TEST_F(PanelText, numbers_of_the_live_plan_end_at_the_right_of_their_columns) {
  settings_.plan = true;
  const PlanRow rows[] = {row(PlanPart::evaluation, "sample", true, 7, 1, 3.25)};
  facts_.rows = rows;
  written();
  ImGuiTable* table = nullptr;
  for (int i = 0; i < context_->Tables.GetMapSize(); ++i)
    if (ImGuiTable* t = context_->Tables.TryGetMapData(i); t != nullptr && t->ColumnsCount == 5) table = t;
  ASSERT_NE(table, nullptr);
  const float unit = ImGui::GetFontSize();
  const float widths[] = {13.0f, 2.2f, 4.5f, 4.5f};
  for (int c = 0; c < 4; ++c) EXPECT_NEAR(table->Columns[c].WidthGiven, widths[c] * unit, 1.0f) << c;
  for (const int c : {2, 3})
    EXPECT_NEAR(table->Columns[c].ContentMaxXUnfrozen, table->Columns[c].WorkMaxX, 1.0f) << "right-aligned, " << c;
  EXPECT_LT(table->Columns[0].ContentMaxXUnfrozen, table->Columns[0].WorkMaxX - unit) << "left-aligned";
}

TEST_F(PanelText, the_live_plan_stands_at_the_right_edge_as_wide_as_there_is_room) {
  settings_.plan = true;
  const float unit = 13.0f;  // of ImGui's own font
  // Beside the panel of 26 units where there is room for 44 more, else over it; at most 64 units wide.
  for (const auto& [room, width] : {std::pair{1600.0f, 64 * unit},
                                    {1100.0f, 1100.0f - 29 * unit},
                                    {700.0f, 44 * unit},
                                    {400.0f, 400.0f - 2 * unit}}) {
    ImGui::DestroyContext(context_);
    context_ = ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.DisplaySize = {room, 720};
    io.DeltaTime = 1.0f / 60.0f;
    unsigned char* pixels = nullptr;
    int w = 0, h = 0;
    io.Fonts->GetTexDataAsAlpha8(&pixels, &w, &h);
    written();
    EXPECT_NEAR(plan_window().Size.x, std::min(width, room - 2 * unit), 1.0f) << room;
    EXPECT_NEAR(plan_window().Pos.x + plan_window().Size.x, room - unit, 1.5f) << room;
    EXPECT_NEAR(plan_window().Pos.y, unit, 1.0f);
  }
}

}  // namespace
}  // namespace sinew::viewer
