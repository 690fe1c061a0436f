// SPDX-License-Identifier: MIT
#include "viewer/app/panel/panel.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <gtest/gtest.h>

#include <tuple>

#include "tests/viewer/imgui_fixture.h"
#include "viewer/app/scene_choice.h"

namespace sinew::viewer {
namespace {

class PanelTest : public ImguiTest {
 protected:
  PanelTest() {
    for (const double duration : {2.0, 3.0}) scene_.animations.emplace_back().duration_s = duration;
    scene_.skins.emplace_back();
    facts_.name = "test";
    facts_.scene = &scene_;
    facts_.needs = &needs_;
    facts_.scene_names = names_;
  }

  PanelRequests frame(Playback& playback) {
    ImGui::NewFrame();
    const PanelRequests requests = lay_out_panel(facts_, settings_, playback);
    ImGui::Render();
    return requests;
  }

  // Clicks the item with that label. Returns the requests of all frames.
  PanelRequests click(const char* label, Playback& playback) {
    frame(playback);
    return click(label, "sinew (h hides this)", playback);
  }

  // Opens a list of choices and presses one of them.
  PanelRequests choose(const char* list, const char* item, Playback& playback) {
    click(list, playback);
    frame(playback);
    return click(item, "##Combo_00", playback);
  }

  // Drags a slider to that end of the screen.
  void slide(const char* label, float x, Playback& playback) {
    frame(playback);
    if (!hover(id_of(label, "sinew (h hides this)"), label, playback)) return;
    ImGui::GetIO().MouseDown[0] = true;
    frame(playback);
    ImGui::GetIO().MousePos.x = x;
    frame(playback);
    ImGui::GetIO().MouseDown[0] = false;
    frame(playback);
  }

  // This version of ImGui has no test hooks: moves the mouse over the panel until the item is hovered.
  bool hover(ImGuiID id, const char* label, Playback& playback) {
    ImGuiContext& g = *context_;
    for (float y = 10; y < 700 && g.HoveredId != id; y += 4)
      for (float x = 20; x < 360 && g.HoveredId != id; x += 6) {
        ImGui::GetIO().MousePos = {x, y};
        frame(playback);
      }
    EXPECT_EQ(g.HoveredId, id) << label << " is nowhere";
    return g.HoveredId == id;
  }

  // in   number  id of the item, for repeated names
  static ImGuiID id_of(const char* label, const char* window_name, const int* number = nullptr) {
    ImGuiWindow* window = ImGui::FindWindowByName(window_name);
    if (window == nullptr) {
      ADD_FAILURE() << "no window " << window_name;
      return 0;
    }
    return number ? ImHashStr(label, 0, ImHashData(number, sizeof *number, window->ID)) : window->GetID(label);
  }

  PanelRequests click(const char* label, const char* window_name, Playback& playback) {
    PanelRequests requests;
    if (!hover(id_of(label, window_name), label, playback)) return requests;
    for (const bool down : {true, false}) {
      ImGui::GetIO().MouseDown[0] = down;
      const PanelRequests now = frame(playback);
      requests.frame_all |= now.frame_all;
      if (now.scene) requests.scene = now.scene;
    }
    return requests;
  }

  Scene scene_;
  Needs needs_;
  std::vector<std::string> names_{"first", "second"};
  PanelFacts facts_;
  Settings settings_;
};

TEST_F(PanelTest, leaves_free_what_is_beside_the_panel) {
  Playback playback(scene_);
  frame(playback);
  const float room = ImGui::GetIO().DisplaySize.x, unit = ImGui::GetFontSize();
  const FreePart free = frame(playback).free;
  EXPECT_NEAR(free.left, 2.0 * static_cast<double>(27.0f * unit / room) - 1.0, 1e-6) << "26 units, one from the left";
  EXPECT_EQ(free.right, 1.0);
  ImGui::SetWindowPos("sinew (h hides this)", {room - 20.0f * unit, unit});
  EXPECT_NEAR(frame(playback).free.right, 1.0 - 2.0 * static_cast<double>(20.0f * unit / room), 1e-6) << "on the right";
  ImGui::SetWindowCollapsed("sinew (h hides this)", true);
  const FreePart above{-1.0, 1.0, frame(playback).free.bottom};
  EXPECT_EQ(frame(playback).free, above) << "the timeline stays";
  EXPECT_GT(above.bottom, -1.0);
  ImGui::GetIO().DisplaySize.x = 30.0f * unit;
  ImGui::SetWindowPos("sinew (h hides this)", {unit, unit});
  ImGui::SetWindowCollapsed("sinew (h hides this)", false);
  frame(playback);
  EXPECT_EQ(frame(playback).free.left, -1.0) << "too little is left";
  EXPECT_EQ(frame(playback).free.right, 1.0);
  settings_.panel = false;
  EXPECT_EQ(frame(playback).free, FreePart{});
}

TEST_F(PanelTest, draws_something_only_while_it_is_shown) {
  Playback playback(scene_);
  frame(playback);
  frame(playback);
  EXPECT_GT(ImGui::GetDrawData()->TotalVtxCount, 100);
  settings_.panel = false;
  frame(playback);
  EXPECT_EQ(ImGui::GetDrawData()->TotalVtxCount, 0);
}

TEST_F(PanelTest, the_choice_of_updates_is_in_the_panel_where_something_moves) {
  Playback playback(scene_);
  facts_.updates = "every 4th frame, interpolated in between: 3 % of the picture's height";
  frame(playback);
  frame(playback);
  const int vertices = ImGui::GetDrawData()->TotalVtxCount;
  facts_.updates.clear();
  frame(playback);
  frame(playback);
  EXPECT_LT(ImGui::GetDrawData()->TotalVtxCount, vertices) << "the reason was shown";
  click("updates", playback);
  EXPECT_TRUE(ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId));
}

TEST_F(PanelTest, a_geometry_cache_has_a_weight_and_says_how_it_plays) {
  const Scene still;
  facts_.scene = &still;
  Playback playback(still, 2.0);
  const auto vertices = [&] {
    frame(playback);
    frame(playback);
    return ImGui::GetDrawData()->TotalVtxCount;
  };
  const int without = vertices();
  facts_.cache.emplace();
  facts_.cache->name = "flag.sgeo";
  facts_.cache->ns_per_vertex = 3.5;
  const int with = vertices();
  EXPECT_GT(with, without + 200);
  facts_.cache->fault = "flag.sgeo: cache-checksum: a frame is not as it was written";
  EXPECT_GT(vertices(), with + 100);
  click("cache", playback);
  EXPECT_LT(settings_.cache_weight, 0.1f) << "the slider was clicked at its left end";
}

TEST_F(PanelTest, switches_change_the_settings) {
  Playback playback(scene_);
  click("dual quaternion", playback);
  EXPECT_EQ(settings_.skinning, Skinning::dual_quaternion);
  click("center of rotation", playback);
  EXPECT_EQ(settings_.skinning, Skinning::center_of_rotation);
  click("linear blend", playback);
  EXPECT_EQ(settings_.skinning, Skinning::linear);
  choose("occlusion", "ssao: points", playback);
  EXPECT_TRUE(settings_.ambient_occlusion && settings_.occlusion_method == OcclusionMethod::ssao);
  choose("occlusion", "none", playback);
  EXPECT_FALSE(settings_.ambient_occlusion);
  facts_.has_visibility = true;
  choose("occlusion", "rays: at vertices", playback);
  EXPECT_TRUE(settings_.ambient_occlusion && settings_.occlusion_method == OcclusionMethod::rays);
  choose("occlusion", "gtao: horizons", playback);
  EXPECT_TRUE(settings_.ambient_occlusion && settings_.occlusion_method == OcclusionMethod::gtao);
  for (const auto& [name, look] : {std::pair{"none", GroundLook::none}, {"grid", GroundLook::grid}}) {
    choose("ground", name, playback);
    EXPECT_EQ(settings_.ground, look);
  }
  click("skeleton", playback);
  EXPECT_TRUE(settings_.skeleton);
  click("ao", playback);
  EXPECT_EQ(settings_.show, Show::ao);
  EXPECT_TRUE(click("frame all", playback).frame_all);
  EXPECT_TRUE(choose("frame", "follow", playback).frame_all) << "at once";
  EXPECT_EQ(settings_.framing, Framing::follow);
}

TEST_F(PanelTest, rays_that_were_asked_for_and_not_cast_are_in_the_list_while_they_are_chosen) {
  Playback playback(scene_);
  settings_.occlusion_method = OcclusionMethod::rays;  // by the command line of a program without Embree
  choose("occlusion", "rays: at vertices", playback);
  EXPECT_TRUE(settings_.ambient_occlusion && settings_.occlusion_method == OcclusionMethod::rays);
  choose("occlusion", "ssao: points", playback);
  EXPECT_EQ(settings_.occlusion_method, OcclusionMethod::ssao);
}

TEST_F(PanelTest, sliders_go_from_end_to_end) {
  Playback playback(scene_);
  facts_.cache.emplace();
  const float left = 0.0f, right = 1279.0f;
  const std::tuple<const char*, float*, float, float> sliders[] = {
      {"exposure", &settings_.exposure_ev, -6.0f, 6.0f},
      {"turn", &settings_.environment_turn_deg, -180.0f, 180.0f},
      {"cache", &settings_.cache_weight, 0.0f, 1.0f}};
  for (const auto& [name, value, lowest, highest] : sliders) {
    slide(name, right, playback);
    EXPECT_EQ(*value, highest) << name;
    slide(name, left, playback);
    EXPECT_EQ(*value, lowest) << name;
  }
}

TEST_F(PanelTest, looks_are_chosen_from_lists) {
  Playback playback(scene_);
  for (const auto& [name, backdrop] : {std::pair{"sharp", Backdrop::sharp}, {"plain", Backdrop::plain}}) {
    choose("backdrop", name, playback);
    EXPECT_EQ(settings_.backdrop, backdrop);
  }
  choose("shading", "gooch", playback);
  EXPECT_EQ(settings_.shading, Shading::gooch);
  for (const auto& [name, curve] : {std::pair{"aces", ToneCurve::aces}, {"none", ToneCurve::none}}) {
    choose("tone", name, playback);
    EXPECT_EQ(settings_.tone_curve, curve);
  }
  for (const auto& [name, show] :
       {std::pair{"normals", Show::normals}, {"depth", Show::depth}, {"color", Show::color}}) {
    click(name, playback);
    EXPECT_EQ(settings_.show, show);
  }
  settings_.shadows = settings_.smooth_edges = settings_.auto_exposure = false;
  for (const auto& [name, value] : {std::pair{"shadows", &settings_.shadows},
                                    {"smooth edges", &settings_.smooth_edges},
                                    {"exposure follows the picture", &settings_.auto_exposure}}) {
    click(name, playback);
    EXPECT_TRUE(*value) << name;
  }
}

TEST_F(PanelTest, the_order_of_what_blends_is_chosen_where_something_does) {
  Playback playback(scene_);
  frame(playback);
  frame(playback);
  const int without = ImGui::GetDrawData()->TotalVtxCount;
  scene_.materials.emplace_back().alpha_mode = AlphaMode::blend;
  frame(playback);
  frame(playback);
  EXPECT_GT(ImGui::GetDrawData()->TotalVtxCount, without);
  choose("blended", "weighted", playback);
  EXPECT_EQ(settings_.transparency, Transparency::weighted);
  choose("blended", "sorted", playback);
  EXPECT_EQ(settings_.transparency, Transparency::sorted);
}

TEST_F(PanelTest, cameras_variants_and_clips_are_those_of_the_file) {
  scene_.cameras = {{.name = "front", .joint = 0}, {.name = "unused", .joint = kNone}, {.name = "side", .joint = 0}};
  scene_.variants = {"day", "night"};
  Playback playback(scene_);
  const auto choose_number = [&](const char* list, int number, const std::string& item) {
    click(list, playback);
    frame(playback);
    ASSERT_TRUE(hover(id_of(item.c_str(), "##Combo_00", &number), item.c_str(), playback));
    for (const bool down : {true, false}) {
      ImGui::GetIO().MouseDown[0] = down;
      frame(playback);
    }
  };
  choose_number("camera", 2, camera_label(scene_, 2));
  EXPECT_EQ(settings_.camera, 2u);
  choose_number("variant", 1, variant_label(scene_, 1));
  choose_number("clip", 1, clip_label(scene_, 1));
  EXPECT_EQ(settings_.variant, 1u);
  EXPECT_EQ(playback.clip(), 1u);
  choose("camera", camera_label(scene_, kNone).c_str(), playback);
  EXPECT_EQ(settings_.camera, kNone);
  choose("variant", variant_label(scene_, kNone).c_str(), playback);
  EXPECT_EQ(settings_.variant, kNone);
}

TEST_F(PanelTest, every_section_opens_without_a_device) {
  Playback playback(scene_);
  facts_.note = "a note";
  facts_.device = "none";
  frame(playback);
  frame(playback);
  const int before = ImGui::GetDrawData()->TotalVtxCount;
  click("keys", playback);
  frame(playback);
  frame(playback);
  EXPECT_GT(ImGui::GetDrawData()->TotalVtxCount, before + 400);  // the key table
}

TEST_F(PanelTest, the_live_plan_opens_beside_the_panel_and_grows_with_its_rows) {
  Playback playback(scene_);
  const auto drawn = [&] {
    frame(playback);
    frame(playback);
    return ImGui::GetDrawData()->TotalVtxCount;
  };
  const int without = drawn();
  EXPECT_EQ(ImGui::FindWindowByName("live plan (e hides this)"), nullptr);
  click("live plan", playback);
  EXPECT_TRUE(settings_.plan);
  const int empty = drawn();
  EXPECT_GT(empty, without);
  const PlanRow rows[] = {{.part = PlanPart::evaluation,
                           .stage = "sample",
                           .runs = true,
                           .reason = "a clip plays",
                           .count = 12,
                           .timed = 1,
                           .time_us = 3.0},
                          {.part = PlanPart::passes, .stage = "ssao", .reason = "nothing opaque is in view"}};
  facts_.rows = rows;
  EXPECT_GT(drawn(), empty + 200);
  const ImGuiWindow *panel = ImGui::FindWindowByName("sinew (h hides this)"),
                    *plan = ImGui::FindWindowByName("live plan (e hides this)");
  EXPECT_GE(plan->Pos.x, panel->Pos.x + panel->Size.x) << "beside, not over";
  settings_.panel = false;
  frame(playback);
  EXPECT_EQ(ImGui::GetDrawData()->TotalVtxCount, 0) << "h hides both";
}

TEST_F(PanelTest, the_live_plan_is_as_high_as_its_rows_and_no_higher_than_the_window) {
  Playback playback(scene_);
  settings_.plan = true;
  const std::vector<PlanRow> rows(100, {.part = PlanPart::passes, .stage = "ssao", .reason = "nothing is in view"});
  const float unit = 13.0f;  // height of the font
  const auto height = [&](float room, std::span<const PlanRow> shown) {
    ImGui::GetIO().DisplaySize = {1280, room};
    facts_.rows = shown;
    frame(playback);
    frame(playback);
    return ImGui::FindWindowByName("live plan (e hides this)")->Size.y;
  };
  EXPECT_LT(height(720, {}), 10 * unit);
  EXPECT_EQ(height(720, rows), 720 - 2 * unit);
  EXPECT_EQ(height(500, rows), 500 - 2 * unit);
  EXPECT_EQ(height(70, rows), 4 * unit) << "two rows are seen in any window";
}

TEST_F(PanelTest, another_scene_is_requested_by_its_index) {
  Playback playback(scene_);
  EXPECT_FALSE(click("scene", playback).scene);
  frame(playback);
  EXPECT_EQ(click("second", "##Combo_00", playback).scene, 1u);
  click("scene", playback);
  frame(playback);
  EXPECT_EQ(click("first", "##Combo_00", playback).scene, 0u);
}

TEST_F(PanelTest, each_choice_of_updates_is_the_one_by_its_name) {
  Playback playback(scene_);
  for (const Updates updates : {Updates::held, Updates::interpolated, Updates::every}) {
    choose("updates", std::string(name_of(updates)).c_str(), playback);
    EXPECT_EQ(settings_.updates, updates);
  }
}

TEST_F(PanelTest, an_empty_scene_has_a_panel_as_well) {
  scene_ = Scene{};
  names_ = {"only"};
  facts_.scene_names = names_;
  Playback playback(scene_);
  frame(playback);
  frame(playback);
  EXPECT_GT(ImGui::GetDrawData()->TotalVtxCount, 100);
}

}  // namespace
}  // namespace sinew::viewer
