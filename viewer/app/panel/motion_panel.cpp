// SPDX-License-Identifier: MIT
#include "viewer/app/panel/motion_panel.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <imgui.h>

#include "viewer/app/panel/show_text.h"
#include "viewer/app/scene_choice.h"

namespace sinew::viewer {
namespace {

std::string joint_label(const Scene& scene, std::uint32_t joint) {
  if (joint == kNone) return "whole body";
  const std::string& name = scene.skeleton.names[joint];
  return "from " + (name.empty() ? "node " + std::to_string(scene.skeleton.node_of_joint[joint]) : name);
}

void layer_clip_choice(const Scene& scene, LayerSetting& layer) {
  if (!ImGui::BeginCombo("##clip", clip_label(scene, layer.clip).c_str())) return;
  for (std::uint32_t clip = 0; clip < scene.animations.size(); ++clip) {
    ImGui::PushID(static_cast<int>(clip));
    if (ImGui::Selectable(clip_label(scene, clip).c_str(), clip == layer.clip)) layer.clip = clip;
    ImGui::PopID();
  }
  ImGui::EndCombo();
}

void mask_choice(const Scene& scene, LayerSetting& layer) {
  if (!ImGui::BeginCombo("##mask", joint_label(scene, layer.mask).c_str())) return;
  if (ImGui::Selectable(joint_label(scene, kNone).c_str(), layer.mask == kNone)) layer.mask = kNone;
  for (std::uint32_t joint = 0; joint < scene.skeleton.joint_count(); ++joint) {
    ImGui::PushID(static_cast<int>(joint));
    if (ImGui::Selectable(joint_label(scene, joint).c_str(), joint == layer.mask)) layer.mask = joint;
    ImGui::PopID();
  }
  ImGui::EndCombo();
}

/// Lays out one layer. Returns true if the user removes it.
bool layer_controls(const Scene& scene, LayerSetting& layer) {
  layer_clip_choice(scene, layer);
  ImGui::SameLine();
  const bool removed = ImGui::SmallButton("x");
  const float least = layer.use == LayerUse::cover ? 0.0f : -1.0f;
  ImGui::SliderFloat("weight", &layer.weight, least, 1.0f, "%.2f", ImGuiSliderFlags_AlwaysClamp);
  mask_choice(scene, layer);
  int use = static_cast<int>(layer.use);
  ImGui::RadioButton("cover", &use, static_cast<int>(LayerUse::cover));
  ImGui::SameLine();
  ImGui::RadioButton("add", &use, static_cast<int>(LayerUse::add_to_rest));
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("adds the difference from the rest pose");
  ImGui::SameLine();
  ImGui::RadioButton("add from start", &use, static_cast<int>(LayerUse::add_to_start));
  layer.use = static_cast<LayerUse>(use);
  if (layer.use == LayerUse::cover) layer.weight = std::max(layer.weight, 0.0f);
  ImGui::SameLine();
  ImGui::Checkbox("mirror", &layer.mirrored);
  return removed;
}

void layer_list(const Scene& scene, MotionSettings& settings) {
  constexpr std::size_t kMostLayers = 8;
  std::optional<std::size_t> removed;
  for (std::size_t i = settings.layers.size(); i-- > 0;) {  // the top one first, as it lies
    ImGui::PushID(static_cast<int>(i));
    if (layer_controls(scene, settings.layers[i])) removed = i;
    ImGui::Separator();
    ImGui::PopID();
  }
  if (removed) settings.layers.erase(settings.layers.begin() + static_cast<std::ptrdiff_t>(*removed));
  if (settings.layers.size() < kMostLayers && ImGui::Button("add layer")) settings.layers.push_back({});
}

void root_choice(MotionSettings& settings) {
  constexpr const char* kNames[] = {"as in the clip", "in place", "moving on"};
  const auto at = static_cast<std::size_t>(settings.root);
  if (!ImGui::BeginCombo("root", kNames[at])) return;
  for (std::size_t i = 0; i < std::size(kNames); ++i)
    if (ImGui::Selectable(kNames[i], i == at)) settings.root = static_cast<RootPlay>(i);
  ImGui::EndCombo();
}

void expression_sliders(const CharacterRig& rig, MotionSettings& settings) {
  if (rig.expressions.empty() || !ImGui::CollapsingHeader("expressions")) return;
  settings.expressions.resize(rig.expressions.size(), 0.0f);
  for (std::size_t e = 0; e < rig.expressions.size(); ++e) {
    ImGui::PushID(static_cast<int>(e));
    ImGui::SliderFloat(rig.expressions[e].name.c_str(), &settings.expressions[e], 0.0f, 1.0f, "%.2f",
                       ImGuiSliderFlags_AlwaysClamp);
    ImGui::PopID();
  }
}

/// The range of a slider: it reaches a quarter beyond all points of blend spaces and all conditions that the parameter
/// meets.
std::pair<float, float> range_of(const GraphTables& tables, GraphIndex parameter) {
  float least = std::min(0.0f, tables.parameters[parameter].initial);
  float most = std::max(0.0f, tables.parameters[parameter].initial);
  const auto meet = [&](float value) {
    least = std::min(least, value);
    most = std::max(most, value);
  };
  for (const GraphBlendSpace& space : tables.spaces)
    for (std::size_t p = space.first_point; p < std::size_t{space.first_point} + space.point_count; ++p) {
      if (space.x == parameter) meet(tables.points[p].x);
      if (space.y == parameter) meet(tables.points[p].y);
    }
  for (const GraphCondition& condition : tables.conditions)
    if (condition.parameter == parameter) meet(condition.value);
  if (least == most) most = least + 1.0f;
  const float beyond = 0.25f * (most - least);
  return {least < 0.0f ? least - beyond : least, most + beyond};
}

void morph_sliders(const Scene& scene, MotionSettings& settings) {
  if (scene.weight_count() == 0 || !ImGui::CollapsingHeader("morph targets")) return;
  bool own = !settings.morph_weights.empty();
  if (ImGui::Checkbox("set by hand", &own))
    settings.morph_weights = own ? rest_weights_of(scene) : std::vector<float>();
  if (settings.morph_weights.size() != scene.weight_count()) return;
  for (std::size_t i = 0; i < scene.instances.size(); ++i) {
    const Mesh& mesh = scene.meshes[scene.instances[i].mesh];
    for (std::size_t t = 0; t < mesh.target_count(); ++t) {
      const std::size_t weight = scene.first_weight[i] + t;
      const std::string name = t < mesh.target_names.size() ? mesh.target_names[t] : "target " + std::to_string(t);
      ImGui::PushID(static_cast<int>(weight));
      ImGui::SliderFloat(name.c_str(), &settings.morph_weights[weight], 0.0f, 1.0f, "%.2f");
      ImGui::PopID();
    }
  }
}

void parameter_control(GraphPlayer& player, GraphIndex index) {
  const GraphTables& tables = player.graph().graph.tables();
  if (player.graph().graph.is_computed(index)) return;
  const GraphParameter& parameter = tables.parameters[index];
  const std::string name(tables.name_at(parameter.name));
  float value = player.parameters()[index];
  switch (parameter.kind) {
    case GraphParameterKind::number: {
      const auto [least, most] = range_of(tables, index);
      if (ImGui::SliderFloat(name.c_str(), &value, least, most, "%.2f")) player.set_parameter(index, value);
      break;
    }
    case GraphParameterKind::flag: {
      bool on = value != 0.0f;
      if (ImGui::Checkbox(name.c_str(), &on)) player.set_parameter(index, on ? 1.0f : 0.0f);
      break;
    }
    case GraphParameterKind::trigger:
      if (ImGui::Button(name.c_str())) player.set_parameter(index, 1.0f);
      break;
  }
}

}  // namespace

void lay_out_motion(const PanelFacts& facts, MotionSettings& settings) {
  morph_sliders(*facts.scene, settings);
  if (facts.scene->animations.empty() &&
      (!facts.rig || (!facts.rig->has_procedures() && facts.rig->expressions.empty())))
    return;
  if (!ImGui::CollapsingHeader("motion")) return;
  if (!facts.scene->animations.empty()) {
    if (facts.rig && facts.rig->root.joint != kNone) root_choice(settings);
    if (!facts.graph) {
      ImGui::Checkbox("mirror the clip", &settings.mirrored);
      ImGui::SliderFloat("fade", &settings.fade_s, 0.0f, 2.0f, "%.2f s", ImGuiSliderFlags_AlwaysClamp);
      if (ImGui::IsItemHovered()) ImGui::SetTooltip("cross-fade to the next clip that you choose");
    }
    layer_list(*facts.scene, settings);
  }
  if (!facts.rig) return;
  if (facts.rig->has_procedures()) ImGui::Checkbox("springs", &settings.springs);
  expression_sliders(*facts.rig, settings);
}

void lay_out_graph(const PanelFacts& facts) {
  if (!facts.graph) return;
  GraphPlayer& player = *facts.graph;
  const GraphTables& tables = player.graph().graph.tables();
  for (GraphIndex p = 0; p < tables.parameters.size(); ++p) parameter_control(player, p);
  for (const GraphStateView& state : player.states()) {
    const std::string label = std::string(player.machine_name(state)) + ": " + std::string(player.state_name(state));
    ImGui::ProgressBar(state.weight, {ImGui::GetFontSize() * 5.0f, 0.0f});
    ImGui::SameLine();
    ImGui::Text("%s  %.2f s", label.c_str(), state.time_s);
  }
  if (!ImGui::CollapsingHeader("program of the pose")) return;
  for (const PoseOp& op : facts.program) {
    const bool samples = op.kind == PoseOpKind::sample || op.kind == PoseOpKind::sample_mirrored;
    const std::string what = samples ? clip_label(*facts.scene, op.index) : std::string();
    if (samples)
      ImGui::Text("%s %s at %.3f s x %.3f", name_of(op.kind), what.c_str(), op.time_s, static_cast<double>(op.weight));
    else
      ImGui::Text("%s %u x %.3f", name_of(op.kind), op.index, static_cast<double>(op.weight));
  }
}

}  // namespace sinew::viewer
