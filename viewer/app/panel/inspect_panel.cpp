// SPDX-License-Identifier: MIT
#include "viewer/app/panel/inspect_panel.h"

#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include <imgui.h>
#include <glm/trigonometric.hpp>

#include "runtime/math/decompose.h"
#include "runtime/math/euler.h"
#include "runtime/math/inverse.h"
#include "viewer/app/inspect/pick.h"
#include "viewer/app/panel/show_text.h"
#include "viewer/app/timeline/channels.h"

namespace sinew::viewer {
namespace {

void vector_row(const char* name, const glm::dvec3& v, const char* unit) {
  ImGui::Text("%-9s %9.4g %9.4g %9.4g %s", name, v.x, v.y, v.z, unit);
}

/// The things at a joint: meshes, cameras, lights.
std::string attachments(const Scene& scene, std::uint32_t joint) {
  std::string text;
  const auto add = [&](const char* kind, std::string_view name) {
    text.append(text.empty() ? "" : ", ").append(kind).append(name.empty() ? "" : " ").append(name);
  };
  for (const MeshInstance& instance : scene.instances)
    if (instance.joint == joint) add("mesh", scene.meshes[instance.mesh].name);
  for (const Camera& camera : scene.cameras)
    if (camera.joint == joint) add("camera", camera.name.str());
  for (const Light& light : scene.lights)
    if (light.joint == joint) add("light", light.name.str());
  for (const Skin& skin : scene.skins)
    if (std::find(skin.joints.begin(), skin.joints.end(), joint) != skin.joints.end()) add("bone of skin", skin.name);
  return text;
}

void node(const Scene& scene, const std::vector<std::vector<std::uint32_t>>& children, std::uint32_t joint,
          std::uint32_t& chosen) {
  ImGui::PushID(static_cast<int>(joint));  // names may repeat
  ImGuiTreeNodeFlags flags = ImGuiTreeNodeFlags_OpenOnArrow | ImGuiTreeNodeFlags_DefaultOpen;
  if (children[joint].empty()) flags |= ImGuiTreeNodeFlags_Leaf;
  if (joint == chosen) flags |= ImGuiTreeNodeFlags_Selected;
  const bool open = ImGui::TreeNodeEx("node", flags, "%s", joint_label(scene, joint).c_str());
  if (ImGui::IsItemClicked() && !ImGui::IsItemToggledOpen()) chosen = joint;
  if (open) {
    for (const std::uint32_t child : children[joint]) node(scene, children, child, chosen);
    ImGui::TreePop();
  }
  ImGui::PopID();
}

/// All nodes as a tree, or those that are searched as a list.
void nodes(const Scene& scene, std::uint32_t& chosen, float height) {
  static ImGuiTextFilter search;  // there is one such window
  search.Draw("search", -ImGui::CalcTextSize("search ").x);
  if (ImGui::BeginChild("nodes", {0.0f, height}, true)) {
    const auto count = static_cast<std::uint32_t>(scene.skeleton.joint_count());
    if (search.IsActive()) {
      for (std::uint32_t joint = 0; joint < count; ++joint) {
        if (!search.PassFilter(joint_label(scene, joint).c_str())) continue;
        ImGui::PushID(static_cast<int>(joint));
        if (ImGui::Selectable(joint_label(scene, joint).c_str(), joint == chosen)) chosen = joint;
        ImGui::PopID();
      }
    } else {
      std::vector<std::vector<std::uint32_t>> children(count);
      for (std::uint32_t joint = 0; joint < count; ++joint)
        if (scene.skeleton.parents[joint] != kNone) children[scene.skeleton.parents[joint]].push_back(joint);
      for (std::uint32_t joint = 0; joint < count; ++joint)
        if (scene.skeleton.parents[joint] == kNone) node(scene, children, joint, chosen);
    }
  }
  ImGui::EndChild();
}

void joint_values(const Scene& scene, const FrameResult& pose, std::uint32_t joint) {
  const std::uint32_t parent = scene.skeleton.parents[joint];
  const Affined world = affine_cast<double>(pose.model[joint]);
  const auto parent_from_world =
      parent == kNone ? Affined() : inverse_of(affine_cast<double>(pose.model[parent])).value_or(Affined());
  const TrsT<double> trs = decompose_trs(parent_from_world * world);
  const std::uint32_t file_node =
      joint < scene.skeleton.node_of_joint.size() ? scene.skeleton.node_of_joint[joint] : kNone;
  if (file_node == kNone)
    ImGui::Text("%s: joint %u", joint_label(scene, joint).c_str(), joint);
  else
    ImGui::Text("%s: joint %u, node %u of the file", joint_label(scene, joint).c_str(), joint, file_node);
  ImGui::PushTextWrapPos(0.0f);
  if (const std::string text = attachments(scene, joint); !text.empty()) show_text(text);
  ImGui::PopTextWrapPos();
  vector_row("position", trs.transform.translation, "m");
  vector_row("rotation", glm::degrees(euler_from_matrix(EulerOrder{}, matrix_from_quat(trs.transform.rotation))),
             "deg");
  vector_row("scale", trs.transform.scale, trs.status == DecomposeStatus::sheared ? "and shear" : "");
  vector_row("in world", translation_of(world), "m");
}

void vertex_values(const Scene& scene, const FrameResult& pose, Inspected& inspected) {
  const VertexPlace& place = inspected.vertex;
  const Mesh& mesh = scene.meshes[scene.instances[place.instance].mesh];
  const Primitive& primitive = mesh.primitives[place.primitive];
  const std::uint32_t in_file = primitive.source_vertex.empty() ? place.vertex : primitive.source_vertex[place.vertex];
  ImGui::Separator();
  ImGui::Text("vertex %u of mesh %s, primitive %u", in_file, mesh.name.c_str(), place.primitive);
  vector_row("in world", position_of(scene, pose, place), "m");
  for (std::size_t set = 0; set < primitive.texcoords.size(); ++set) {
    const glm::vec2 uv = primitive.texcoords[set][place.vertex];
    ImGui::Text("uv %zu      %9.4g %9.4g", set, static_cast<double>(uv.x), static_cast<double>(uv.y));
  }
  for (const Influence& influence : influences_of(scene, place)) {
    char weight[32];
    std::snprintf(weight, sizeof(weight), "%.1f %%", 100.0 * static_cast<double>(influence.weight));
    ImGui::ProgressBar(influence.weight, {6.0f * ImGui::GetFontSize(), ImGui::GetFontSize()}, weight);
    ImGui::SameLine();
    ImGui::PushID(static_cast<int>(influence.joint));
    if (ImGui::Selectable(joint_label(scene, influence.joint).c_str(), influence.joint == inspected.joint))
      inspected.joint = influence.joint;
    ImGui::PopID();
  }
}

void overlay_choice(Settings& settings) {
  Inspected& inspected = settings.inspected;
  ImGui::Checkbox("wireframe", &inspected.wireframe);
  ImGui::SameLine();
  ImGui::Checkbox("boxes", &inspected.boxes);
  ImGui::SameLine();
  ImGui::Checkbox("trail", &inspected.trail);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("the way of the joint through the clip");
  ImGui::SameLine();
  ImGui::Checkbox("onion skin", &inspected.ghosts);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("skeletons shortly before (blue) and after (yellow)");
  static constexpr const char* kPaints[] = {"materials", "weights of the joint", "uv"};
  if (!ImGui::BeginCombo("surface", kPaints[static_cast<std::size_t>(inspected.paint)])) return;
  for (int paint = 0; paint < 3; ++paint)
    if (ImGui::Selectable(kPaints[paint], paint == static_cast<int>(inspected.paint)))
      inspected.paint = static_cast<Paint>(paint);
  ImGui::EndCombo();
}

}  // namespace

FreePart lay_out_inspect(const PanelFacts& facts, Settings& settings, FreePart free) {
  if (!settings.inside) return free;
  const ImVec2 room = ImGui::GetIO().DisplaySize;
  const float unit = ImGui::GetFontSize(), width = std::min(26.0f * unit, room.x - 2.0f * unit);
  ImGui::SetNextWindowPos({room.x - unit, unit}, ImGuiCond_Always, {1.0f, 0.0f});
  ImGui::SetNextWindowSizeConstraints({width, 0.0f}, {width, std::max(room.y - 2.0f * unit, 4.0f * unit)});
  const ImGuiWindowFlags flags =
      ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_AlwaysAutoResize;
  if (ImGui::Begin("look inside (i hides this)", &settings.inside, flags)) {
    const Scene& scene = *facts.scene;
    Inspected& inspected = settings.inspected;
    nodes(scene, inspected.joint, std::clamp(room.y - 32.0f * unit, 6.0f * unit, 22.0f * unit));
    if (facts.pose && inspected.joint < facts.pose->model.size()) joint_values(scene, *facts.pose, inspected.joint);
    if (facts.pose && inspected.vertex.instance < facts.pose->instances.size())
      vertex_values(scene, *facts.pose, inspected);
    ImGui::Separator();
    overlay_choice(settings);
    ImGui::TextDisabled("a click on the model picks a vertex");
  }
  ImGui::End();
  constexpr double kTooNarrow = 0.5;
  const double right = 1.0 - 2.0 * static_cast<double>((width + 1.5f * unit) / room.x);
  if (right - free.left >= kTooNarrow) free.right = std::min(free.right, right);
  return free;
}

}  // namespace sinew::viewer
