// SPDX-License-Identifier: MIT
#include "viewer/app/panel/panel.h"

#include <algorithm>
#include <initializer_list>
#include <string>
#include <utility>

#include <imgui.h>

#include "viewer/app/keys.h"
#include "viewer/app/panel/inspect_panel.h"
#include "viewer/app/panel/messages_panel.h"
#include "viewer/app/panel/motion_panel.h"
#include "viewer/app/panel/plan_panel.h"
#include "viewer/app/panel/show_text.h"
#include "viewer/app/panel/timeline_panel.h"
#include "viewer/app/scene_choice.h"

namespace sinew::viewer {
namespace {

const ImVec4 kFaultColor(1.0f, 0.5f, 0.4f, 1.0f);

void scene_combo(const PanelFacts& facts, PanelRequests& requests) {
  if (facts.scene_names.size() >= 2) {
    if (ImGui::BeginCombo("scene", facts.scene_names[facts.scene_index].c_str())) {
      for (std::uint32_t i = 0; i < facts.scene_names.size(); ++i)
        if (ImGui::Selectable(facts.scene_names[i].c_str(), i == facts.scene_index)) requests.scene = i;
      ImGui::EndCombo();
    }
  } else {
    show_text(facts.name);
  }
  if (!facts.reload_fault.empty()) {
    ImGui::PushTextWrapPos(0.0f);
    ImGui::PushStyleColor(ImGuiCol_Text, kFaultColor);
    show_text("changed, and shown as before:");
    show_text(facts.reload_fault);
    ImGui::PopStyleColor();
    ImGui::PopTextWrapPos();
  }
  lay_out_messages(facts.messages);
  if (facts.note.empty()) return;
  ImGui::PushTextWrapPos(0.0f);
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
  show_text(facts.note);
  ImGui::PopStyleColor();
  ImGui::PopTextWrapPos();
}

void clip_choice(const Scene& scene, Playback& playback) {
  constexpr std::size_t kSearchedFrom = 12;
  const std::string current = clip_label(scene, playback.clip());
  if (!ImGui::BeginCombo("clip", current.c_str(), ImGuiComboFlags_HeightLarge)) return;
  static ImGuiTextFilter search;  // of the list that is open; there is only one
  if (ImGui::IsWindowAppearing()) search.Clear();
  if (scene.animations.size() >= kSearchedFrom) search.Draw("search", -ImGui::CalcTextSize("search ").x);
  const auto offer = [&](std::uint32_t clip) {
    if (!search.PassFilter(clip_label(scene, clip).c_str())) return;
    ImGui::PushID(static_cast<int>(clip));  // names may repeat
    if (ImGui::Selectable(clip_label(scene, clip).c_str(), clip == playback.clip())) playback.choose(clip);
    ImGui::PopID();
  };
  for (std::uint32_t clip = 0; clip < scene.animations.size(); ++clip) offer(clip);
  offer(kNone);
  ImGui::EndCombo();
}

void skinning_choice(const PanelFacts& facts, Settings& settings) {
  if (facts.scene->skins.empty()) return;
  if (!facts.needs->skin.per_instance.empty()) {
    ImGui::TextDisabled("skinning: the scene chooses for each mesh");
    return;
  }
  if (ImGui::RadioButton("linear blend", settings.skinning == Skinning::linear)) settings.skinning = Skinning::linear;
  ImGui::SameLine();
  if (ImGui::RadioButton("dual quaternion", settings.skinning == Skinning::dual_quaternion))
    settings.skinning = Skinning::dual_quaternion;
  if (ImGui::RadioButton("center of rotation", settings.skinning == Skinning::center_of_rotation))
    settings.skinning = Skinning::center_of_rotation;
}

void updates_choice(const PanelFacts& facts, Settings& settings) {
  if (facts.scene->animations.empty()) return;
  if (ImGui::BeginCombo("updates", std::string(name_of(settings.updates)).c_str())) {
    for (const Updates updates : {Updates::every, Updates::interpolated, Updates::held})
      if (ImGui::Selectable(std::string(name_of(updates)).c_str(), updates == settings.updates))
        settings.updates = updates;
    ImGui::EndCombo();
  }
  ImGui::PushTextWrapPos(0.0f);
  ImGui::TextDisabled("%s", facts.updates.c_str());
  ImGui::PopTextWrapPos();
}

/// A combo box of an enumeration.
/// in   names  of its values, in order from 0
template <class Choice>
void choice(const char* label, std::initializer_list<const char*> names, Choice& chosen) {
  const auto at = static_cast<std::size_t>(chosen);
  if (!ImGui::BeginCombo(label, names.begin()[at])) return;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (ImGui::Selectable(names.begin()[i], i == at)) chosen = static_cast<Choice>(i);
  ImGui::EndCombo();
}

void light_controls(Settings& settings) {
  choice("ground", {"none", "shadows", "grid"}, settings.ground);
  choice("backdrop", {"plain", "blurred", "sharp"}, settings.backdrop);
  choice("shading", {"physical", "gooch"}, settings.shading);
  choice("tone", {"neutral", "aces", "none"}, settings.tone_curve);
  ImGui::SliderFloat("exposure", &settings.exposure_ev, -6.0f, 6.0f, "%+.1f EV");
  ImGui::Checkbox("exposure follows the picture", &settings.auto_exposure);
  ImGui::SliderFloat("turn", &settings.environment_turn_deg, -180.0f, 180.0f, "%.0f deg");
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("turns the light that comes from all around");
}

void cache_controls(const CacheFacts& cache, Settings& settings) {
  show_text(cache.name);
  ImGui::SliderFloat("cache", &settings.cache_weight, 0.0f, 1.0f, "%.2f", ImGuiSliderFlags_AlwaysClamp);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("0: the pose, 1: the geometry cache");
  ImGui::Text("%u frames of %.1f ms, %zu vertices", cache.frame_count, 1e3 * cache.frame_s, cache.vertex_count);
  ImGui::PushTextWrapPos(0.0f);
  show_text(describe_window(cache));
  show_text(describe_cost(cache));
  if (!cache.fault.empty()) ImGui::TextColored(kFaultColor, "%s", std::string(cache.fault).c_str());
  ImGui::PopTextWrapPos();
}

void camera_choice(const Scene& scene, Settings& settings) {
  const bool any =
      std::any_of(scene.cameras.begin(), scene.cameras.end(), [](const Camera& c) { return c.joint != kNone; });
  if (!any || !ImGui::BeginCombo("camera", camera_label(scene, settings.camera).c_str())) return;
  if (ImGui::Selectable(camera_label(scene, kNone).c_str(), settings.camera == kNone)) settings.camera = kNone;
  for (std::uint32_t c = 0; c < scene.cameras.size(); ++c) {
    if (scene.cameras[c].joint == kNone) continue;
    ImGui::PushID(static_cast<int>(c));  // names may repeat
    if (ImGui::Selectable(camera_label(scene, c).c_str(), settings.camera == c)) settings.camera = c;
    ImGui::PopID();
  }
  ImGui::EndCombo();
}

void variant_choice(const Scene& scene, Settings& settings) {
  if (scene.variants.empty() || !ImGui::BeginCombo("variant", variant_label(scene, settings.variant).c_str())) return;
  if (ImGui::Selectable(variant_label(scene, kNone).c_str(), settings.variant == kNone)) settings.variant = kNone;
  for (std::uint32_t v = 0; v < scene.variants.size(); ++v) {
    ImGui::PushID(static_cast<int>(v));
    if (ImGui::Selectable(variant_label(scene, v).c_str(), settings.variant == v)) settings.variant = v;
    ImGui::PopID();
  }
  ImGui::EndCombo();
}

void transparency_choice(const Scene& scene, Settings& settings) {
  const bool blends = std::any_of(scene.materials.begin(), scene.materials.end(),
                                  [](const Material& material) { return material.alpha_mode == AlphaMode::blend; });
  if (blends) choice("blended", {"sorted", "weighted"}, settings.transparency);
}

void look_controls(const PanelFacts& facts, Settings& settings, PanelRequests& requests) {
  camera_choice(*facts.scene, settings);
  variant_choice(*facts.scene, settings);
  skinning_choice(facts, settings);
  updates_choice(facts, settings);
  int occlusion = settings.ambient_occlusion ? 1 + static_cast<int>(settings.occlusion_method) : 0;
  if (facts.has_visibility ||
      settings.occlusion_method == OcclusionMethod::rays)  // was requested with --ao rays, even if baking failed
    choice("occlusion", {"none", "ssao: points", "gtao: horizons", "rays: at vertices"}, occlusion);
  else
    choice("occlusion", {"none", "ssao: points", "gtao: horizons"}, occlusion);
  settings.ambient_occlusion = occlusion > 0;
  if (occlusion > 0) settings.occlusion_method = static_cast<OcclusionMethod>(occlusion - 1);
  ImGui::Checkbox("skeleton", &settings.skeleton);
  ImGui::SameLine();
  ImGui::Checkbox("shadows", &settings.shadows);
  ImGui::SameLine();
  ImGui::Checkbox("smooth edges", &settings.smooth_edges);
  int show = static_cast<int>(settings.show);
  ImGui::RadioButton("color", &show, static_cast<int>(Show::color));
  ImGui::SameLine();
  ImGui::RadioButton("ao", &show, static_cast<int>(Show::ao));
  ImGui::SameLine();
  ImGui::RadioButton("normals", &show, static_cast<int>(Show::normals));
  ImGui::SameLine();
  ImGui::RadioButton("depth", &show, static_cast<int>(Show::depth));
  ImGui::SameLine();
  ImGui::RadioButton("level", &show, static_cast<int>(Show::level));
  settings.show = static_cast<Show>(show);
  light_controls(settings);
  transparency_choice(*facts.scene, settings);
  const Framing before = settings.framing;
  choice("frame", {"clip", "pose", "follow"}, settings.framing);
  requests.frame_all |= settings.framing != before;
  if (ImGui::Button("frame all")) requests.frame_all = true;
}

void key_help() {
  const bool open = ImGui::CollapsingHeader("keys");
  if (ImGui::IsItemToggledOpen()) ImGui::SetScrollHereY(0.0f);  // the table may be below the window
  if (!open) return;
  if (!ImGui::BeginTable("keys", 2, ImGuiTableFlags_SizingFixedFit)) return;
  for (const auto& binding : key_bindings()) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    show_text(binding.name);
    ImGui::TableNextColumn();
    show_text(binding.meaning);
  }
  ImGui::EndTable();
}

/// The wider part of the main window to the left or right of the current ImGui window.
FreePart free_beside_panel(float room) {
  const float left = ImGui::GetWindowPos().x, right = left + ImGui::GetWindowWidth();
  const auto place = [room](float x) { return glm::clamp(2.0 * static_cast<double>(x / room) - 1.0, -1.0, 1.0); };
  const FreePart free = left > room - right ? FreePart{-1.0, place(left)} : FreePart{place(right), 1.0};
  // A quarter of the window: if less is free, the scene uses the whole width, behind the panel.
  constexpr double kTooNarrow = 0.5;
  return free.right - free.left < kTooNarrow ? FreePart{} : free;
}

}  // namespace

PanelRequests lay_out_panel(const PanelFacts& facts, Settings& settings, Playback& playback) {
  PanelRequests requests;
  if (!settings.panel) return requests;
  const float unit = ImGui::GetFontSize();
  const ImVec2 room = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos({unit, unit}, ImGuiCond_FirstUseEver);
  const float width = std::min(unit * 26.0f, std::max(room.x - 2.0f * unit, unit));
  // Height follows the content, up to the height of the window; beyond that it scrolls.
  ImGui::SetNextWindowSizeConstraints({width, 0.0f}, {width, std::max(room.y - 2.0f * unit, 4.0f * unit)});
  const ImGuiWindowFlags flags = ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_AlwaysAutoResize;
  if (ImGui::Begin("sinew (h hides this)", nullptr, flags)) {
    requests.free = free_beside_panel(room.x);
    ImGui::PushItemWidth(-ImGui::CalcTextSize("backdrop  ").x);
    scene_combo(facts, requests);
    ImGui::Separator();
    if (facts.scene->animations.empty() && playback.duration_s() == 0.0)
      ImGui::TextDisabled("no clips: the rest pose is shown");
    if (!facts.scene->animations.empty() && !facts.graph) clip_choice(*facts.scene, playback);
    lay_out_graph(facts);
    lay_out_motion(facts, settings.motion);
    ImGui::Separator();
    if (facts.cache) {
      cache_controls(*facts.cache, settings);
      ImGui::Separator();
    }
    look_controls(facts, settings, requests);
    ImGui::Checkbox("live plan", &settings.plan);
    ImGui::SameLine();
    ImGui::Checkbox("look inside", &settings.inside);
    bool quaternions = settings.normals == NormalInterpolation::quaternion;
    ImGui::Checkbox("normals as quaternions", &quaternions);
    settings.normals = quaternions ? NormalInterpolation::quaternion : NormalInterpolation::interpolated;
    key_help();
    ImGui::PopItemWidth();
  }
  ImGui::End();
  requests.free = lay_out_inspect(facts, settings, requests.free);
  requests.free = lay_out_timeline(facts, settings, playback, requests.free);
  if (settings.plan) lay_out_plan(facts, settings.plan);
  return requests;
}

}  // namespace sinew::viewer
