// SPDX-License-Identifier: MIT
#include "viewer/app/panel/plan_panel.h"

#include <algorithm>
#include <cstdio>

#include <imgui.h>

#include "viewer/app/panel/show_text.h"

namespace sinew::viewer {
namespace {

void right_aligned(const char* number) {
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() +
                       std::max(0.0f, ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(number).x));
  show_text(number);
}

void lay_out_row(const PlanRow& row) {
  char number[32];
  ImGui::TableNextRow();
  ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(row.runs ? ImGuiCol_Text : ImGuiCol_TextDisabled));
  ImGui::TableNextColumn();
  show_text(row.stage);
  ImGui::TableNextColumn();
  show_text(row.runs ? "on" : "off");
  ImGui::TableNextColumn();
  std::snprintf(number, sizeof(number), "%llu", static_cast<unsigned long long>(row.count));
  right_aligned(row.runs ? number : "");
  ImGui::TableNextColumn();
  std::snprintf(number, sizeof(number), "%.1f", row.time_us);
  right_aligned(row.timed > 0 ? number : "");
  ImGui::TableNextColumn();
  ImGui::PushTextWrapPos(0.0f);
  show_text(row.reason);
  ImGui::PopTextWrapPos();
  ImGui::PopStyleColor();
}

void lay_out_table(std::span<const PlanRow> rows) {
  const float unit = ImGui::GetFontSize();
  if (!ImGui::BeginTable("rows", 5, ImGuiTableFlags_RowBg)) return;
  ImGui::TableSetupColumn("stage", ImGuiTableColumnFlags_WidthFixed, 13.0f * unit);
  ImGui::TableSetupColumn("runs", ImGuiTableColumnFlags_WidthFixed, 2.2f * unit);
  ImGui::TableSetupColumn("count", ImGuiTableColumnFlags_WidthFixed, 4.5f * unit);
  ImGui::TableSetupColumn("\xc2\xb5s", ImGuiTableColumnFlags_WidthFixed, 4.5f * unit);
  ImGui::TableSetupColumn("why", ImGuiTableColumnFlags_WidthStretch);
  ImGui::TableHeadersRow();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (i == 0 || rows[i].part != rows[i - 1].part) {
      ImGui::TableNextRow();
      ImGui::TableNextColumn();
      ImGui::TextColored({0.55f, 0.75f, 1.0f, 1.0f}, "%s", std::string(title_of(rows[i].part)).c_str());
    }
    lay_out_row(rows[i]);
  }
  ImGui::EndTable();
}

}  // namespace

void lay_out_plan(const PanelFacts& facts, bool& open) {
  const float unit = ImGui::GetFontSize();
  const ImVec2 room = ImGui::GetIO().DisplaySize;
  const float beside = 28.0f * unit;  // to the right of the main panel if there is room, else over it
  const float width = std::clamp(room.x - beside - unit, std::min(44.0f * unit, room.x - 2.0f * unit), 64.0f * unit);
  ImGui::SetNextWindowPos({room.x - width - unit, unit}, ImGuiCond_FirstUseEver);
  ImGui::SetNextWindowSizeConstraints({width, 0.0f}, {width, std::max(room.y - 2.0f * unit, 4.0f * unit)});
  const ImGuiWindowFlags flags = ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_AlwaysAutoResize;
  if (ImGui::Begin("live plan (e hides this)", &open, flags)) {
    show_text(facts.device);
    ImGui::Text("%.1f ms from picture to picture", facts.frame_ms);
    ImGui::PushTextWrapPos(0.0f);
    if (facts.resting) ImGui::TextDisabled("nothing moves: no pose is evaluated");
    ImGui::PopTextWrapPos();
    lay_out_table(facts.rows);
  }
  ImGui::End();
}

}  // namespace sinew::viewer
