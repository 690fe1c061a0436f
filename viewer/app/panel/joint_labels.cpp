// SPDX-License-Identifier: MIT
#include "viewer/app/panel/joint_labels.h"

#include <algorithm>
#include <string_view>
#include <vector>

#include <imgui.h>

#include "viewer/app/skeleton_lines.h"

namespace sinew::viewer {
namespace {

struct Label {
  ImVec2 lower, upper;

  bool covers(const Label& o) const noexcept {
    return lower.x < o.upper.x && o.lower.x < upper.x && lower.y < o.upper.y && o.lower.y < upper.y;
  }
};

}  // namespace

void lay_out_joint_labels(const Scene& scene, std::span<const Affine> model, const View& view) {
  if (!scene.instances.empty()) return;
  const ImVec2 room = ImGui::GetIO().DisplaySize;
  const Mat4<double> clip = clip_from_view(view, static_cast<double>(room.x) / static_cast<double>(room.y));
  const std::vector<bool> shown = joints_of_skeleton(scene);
  const float aside = 0.5f * ImGui::GetFontSize();
  std::vector<Label> placed;
  for (std::size_t j = 0; j < model.size(); ++j) {
    const std::string_view name = scene.skeleton.names[j];
    if (!shown[j] || name.empty()) continue;
    const glm::dvec4 at =
        clip * glm::dvec4(transform_point(view.view_from_world, glm::dvec3(translation_of(model[j]))), 1.0);
    if (at.w <= 0.0) continue;
    const ImVec2 size = ImGui::CalcTextSize(name.data(), name.data() + name.size());
    const ImVec2 lower(room.x * static_cast<float>(0.5 + 0.5 * at.x / at.w) + aside,
                       room.y * static_cast<float>(0.5 - 0.5 * at.y / at.w) - aside);
    const Label label{lower, {lower.x + size.x, lower.y + size.y}};
    if (std::any_of(placed.begin(), placed.end(), [&](const Label& other) { return label.covers(other); })) continue;
    placed.push_back(label);
    ImGui::GetBackgroundDrawList()->AddText(lower, ImGui::GetColorU32(ImGuiCol_Text), name.data(),
                                            name.data() + name.size());
  }
}

}  // namespace sinew::viewer
