// SPDX-License-Identifier: MIT
#include "viewer/app/panel/messages_panel.h"

#include <imgui.h>

#include "viewer/app/panel/show_text.h"

namespace sinew::viewer {

void lay_out_messages(std::span<const std::string> messages) {
  if (messages.empty()) return;
  const std::string badge =
      std::to_string(messages.size()) + (messages.size() == 1 ? " warning" : " warnings") + "###warnings";
  ImGui::PushStyleColor(ImGuiCol_Text, ImVec4(1.0f, 0.8f, 0.3f, 1.0f));
  const bool open = ImGui::CollapsingHeader(badge.c_str());
  ImGui::PopStyleColor();
  if (!open) return;
  ImGui::PushTextWrapPos(0.0f);
  for (const std::string& message : messages) {
    ImGui::Bullet();
    show_text(message);
  }
  ImGui::PopTextWrapPos();
}

}  // namespace sinew::viewer
