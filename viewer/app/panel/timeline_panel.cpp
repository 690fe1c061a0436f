// SPDX-License-Identifier: MIT
#include "viewer/app/panel/timeline_panel.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>
#include <vector>

#include <imgui.h>

#include "viewer/app/panel/show_text.h"
#include "viewer/app/timeline/channels.h"

namespace sinew::viewer {
namespace {

constexpr ImU32 kKey = IM_COL32(120, 190, 255, 255), kNow = IM_COL32(255, 200, 90, 255);
constexpr ImU32 kMark = IM_COL32(255, 255, 255, 60), kOutside = IM_COL32(0, 0, 0, 110);
constexpr ImU32 kAxes[3] = {IM_COL32(255, 90, 90, 255), IM_COL32(90, 220, 90, 255), IM_COL32(90, 150, 255, 255)};

/// Where the times of the clip are in the window, in pixels.
struct TimeAxis {
  float left = 0.0f, width = 1.0f;
  double duration_s = 1.0;

  float x(double time_s) const { return left + width * static_cast<float>(time_s / duration_s); }
  double time_s(float at) const { return std::clamp(static_cast<double>((at - left) / width), 0.0, 1.0) * duration_s; }
};

/// Continues the line if the next item fits, and begins another one if it does not.
void flow(float width) {
  const float right = ImGui::GetItemRectMax().x + ImGui::GetStyle().ItemSpacing.x + width;
  if (right < ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x) ImGui::SameLine();
}

std::string time_text(const Settings& settings, double time_s, double duration_s) {
  char text[64];
  if (settings.counts_frames)
    std::snprintf(text, sizeof(text), "%6.1f / %.1f frames", time_s / Playback::kFrame_s,
                  duration_s / Playback::kFrame_s);
  else
    std::snprintf(text, sizeof(text), "%.3f / %.3f s", time_s, duration_s);
  return text;
}

void mode_choice(const Scene& scene, Playback& playback) {
  static constexpr std::pair<PlayMode, const char*> kModes[] = {
      {PlayMode::loop, "repeat"}, {PlayMode::ping_pong, "there and back"}, {PlayMode::once, "once"}};
  const char* current = playback.in_turn() ? "all clips in turn" : "hold the end";
  if (!playback.in_turn())
    for (const auto& [mode, name] : kModes)
      if (mode == playback.mode()) current = name;
  if (!ImGui::BeginCombo("##loop", current)) return;
  for (const auto& [mode, name] : kModes)
    if (ImGui::Selectable(name, !playback.in_turn() && mode == playback.mode())) playback.set_mode(mode);
  if (scene.animations.size() > 1 && ImGui::Selectable("all clips in turn", playback.in_turn()))
    playback.play_in_turn();
  ImGui::EndCombo();
}

void speed_choice(Playback& playback) {
  double speed = playback.speed();
  const double slowest = -2.0, fastest = 4.0;
  if (ImGui::SliderScalar("##speed", ImGuiDataType_Double, &speed, &slowest, &fastest, "x %.2f"))
    playback.set_speed(speed);
  if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) playback.set_speed(1.0);
  if (ImGui::IsItemHovered()) ImGui::SetTooltip("speed; right click: x 1");
}

void play_controls(const PanelFacts& facts, Settings& settings, Playback& playback) {
  const float unit = ImGui::GetFontSize();
  if (ImGui::Button("<##step")) playback.step(-1);
  ImGui::SameLine();
  if (ImGui::Button(playback.playing() ? "pause##play" : "play##play", {4.0f * unit, 0.0f})) playback.toggle();
  ImGui::SameLine();
  if (ImGui::Button(">##step")) playback.step(+1);
  const std::string time = time_text(settings, playback.time_s(), playback.duration_s());
  flow(ImGui::CalcTextSize(time.c_str()).x);
  show_text(time);
  flow(4.5f * unit);
  if (ImGui::Button(settings.counts_frames ? "seconds" : "frames")) settings.counts_frames = !settings.counts_frames;
  flow(8.0f * unit);
  ImGui::SetNextItemWidth(8.0f * unit);
  speed_choice(playback);
  flow(9.0f * unit);
  bool backwards = playback.speed() < 0.0;
  if (ImGui::Checkbox("backwards", &backwards)) playback.set_speed(-playback.speed());
  if (facts.graph) return;  // it chooses clips, and has no end
  flow(10.0f * unit);
  ImGui::SetNextItemWidth(10.0f * unit);
  mode_choice(*facts.scene, playback);
  flow(5.0f * unit);
  ImGui::Checkbox("keys", &settings.timeline_keys);
}

/// Draws a key at each time; of keys that would cover each other only the first.
void draw_keys(std::span<const float> times_s, const TimeAxis& axis, float y, float radius) {
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  float last = -1e30f;
  for (const float time : times_s) {
    const float x = axis.x(static_cast<double>(time));
    if (x < last + radius) continue;
    draw.AddQuadFilled({x, y - radius}, {x + radius, y}, {x, y + radius}, {x - radius, y}, kKey);
    last = x;
  }
}

void draw_now(const TimeAxis& axis, double time_s, float top, float bottom) {
  ImGui::GetWindowDrawList()->AddLine({axis.x(time_s), top}, {axis.x(time_s), bottom}, kNow, 2.0f);
}

/// The ruler: dragging seeks, dragging with the right button sets the range that plays.
void ruler(const Settings& settings, Playback& playback, std::span<const float> key_times_s, const TimeAxis& axis) {
  const float unit = ImGui::GetFontSize(), height = 2.2f * unit;
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos({axis.left, corner.y});
  ImGui::InvisibleButton("time", {axis.width, height},
                         ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight);
  const double at = axis.time_s(ImGui::GetIO().MousePos.x);
  if (ImGui::IsItemActive() && ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
    playback.pause();
    playback.seek(at);
  }
  if (ImGui::IsItemActive() && ImGui::IsMouseDown(ImGuiMouseButton_Right))
    playback.set_range(axis.time_s(ImGui::GetIO().MouseClickedPos[ImGuiMouseButton_Right].x), at);
  if (ImGui::IsItemHovered() && !ImGui::IsItemActive())
    ImGui::SetTooltip("drag: go there\nright button: drag a part to play; click: play all");

  ImDrawList& draw = *ImGui::GetWindowDrawList();
  const float right = axis.left + axis.width, bottom = corner.y + height;
  draw.AddRectFilled({axis.left, corner.y}, {right, bottom}, ImGui::GetColorU32(ImGuiCol_FrameBg));
  const double unit_s = settings.counts_frames ? Playback::kFrame_s : 0.001;
  const double step_s = ruler_step(5.0 * static_cast<double>(unit / axis.width) * axis.duration_s, unit_s);
  for (int i = 0; i * step_s <= axis.duration_s; ++i) {
    char text[32];
    if (settings.counts_frames)
      std::snprintf(text, sizeof(text), "%.0f", i * step_s / Playback::kFrame_s);
    else
      std::snprintf(text, sizeof(text), "%.10g", i * step_s);
    const float x = axis.x(i * step_s);
    draw.AddLine({x, corner.y}, {x, bottom}, kMark);
    draw.AddText({x + 3.0f, corner.y}, ImGui::GetColorU32(ImGuiCol_TextDisabled), text);
  }
  draw_keys(key_times_s, axis, bottom - 0.5f * unit, 0.28f * unit);
  if (playback.has_range()) {
    draw.AddRectFilled({axis.left, corner.y}, {axis.x(playback.range_start_s()), bottom}, kOutside);
    draw.AddRectFilled({axis.x(playback.range_end_s()), corner.y}, {right, bottom}, kOutside);
  }
  draw_now(axis, playback.time_s(), corner.y, bottom);
}

void channel_rows(const PanelFacts& facts, Settings& settings, const Playback& playback,
                  std::span<const Channel> channels, const TimeAxis& axis, float height) {
  if (!ImGui::BeginChild("channels", {0.0f, height})) return ImGui::EndChild();
  ImGuiListClipper clipper;
  clipper.Begin(static_cast<int>(channels.size()));
  while (clipper.Step())
    for (int row = clipper.DisplayStart; row < clipper.DisplayEnd; ++row) {
      const Channel& channel = channels[static_cast<std::size_t>(row)];
      const bool of_joint = channel.kind <= ChannelKind::scale;
      const ImVec2 at = ImGui::GetCursorScreenPos();
      ImGui::PushID(row);  // names may repeat
      ImGui::PushClipRect(at, {axis.left - ImGui::GetFontSize(), at.y + 2.0f * ImGui::GetFontSize()}, true);
      if (ImGui::Selectable(channel_label(*facts.scene, playback.clip(), channel).c_str(),
                            of_joint && channel.owner == settings.inspected.joint) &&
          of_joint) {
        settings.inspected.joint = channel.owner;
        settings.curve = channel.kind;
      }
      ImGui::PopClipRect();
      ImGui::PopID();
      draw_keys(channel.times_s, axis, at.y + 0.5f * ImGui::GetFontSize(), 0.25f * ImGui::GetFontSize());
    }
  const ImVec2 corner = ImGui::GetWindowPos();
  draw_now(axis, playback.time_s(), corner.y, corner.y + height);
  ImGui::EndChild();
}

/// The three curves of the joint, their keys, and their values now.
void curve(const PanelFacts& facts, const Settings& settings, const Playback& playback,
           std::span<const Channel> channels, const TimeAxis& axis, float height) {
  const Scene& scene = *facts.scene;
  const auto value = [&](double time_s) {
    return curve_value(scene, playback.clip(), settings.inspected.joint, settings.curve, time_s);
  };
  std::vector<glm::dvec3> samples;
  glm::dvec3 low(value(0.0)), high(low);
  const int count = std::max(2, static_cast<int>(axis.width / 2.0f));
  for (int i = 0; i < count; ++i) {
    samples.push_back(value(axis.duration_s * i / (count - 1)));
    low = glm::min(low, samples.back());
    high = glm::max(high, samples.back());
  }
  const double bottom = std::min({low.x, low.y, low.z}), top = std::max({high.x, high.y, high.z});
  const double spread = std::max(top - bottom, 1e-6 * std::max(std::abs(top), 1.0));
  const ImVec2 corner = ImGui::GetCursorScreenPos();
  const auto y_of = [&](double v) {
    return corner.y + height * static_cast<float>(0.95 - 0.9 * (v - bottom) / spread);
  };
  const Channel own{settings.curve, settings.inspected.joint, {}};
  const glm::dvec3 now = value(playback.time_s());
  char text[96];
  std::snprintf(text, sizeof(text), "x %.4g\ny %.4g\nz %.4g%s", now.x, now.y, now.z,
                settings.curve == ChannelKind::rotation ? " degrees" : "");
  show_text(channel_label(scene, playback.clip(), own));
  show_text(text);
  ImDrawList& draw = *ImGui::GetWindowDrawList();
  draw.AddRectFilled({axis.left, corner.y}, {axis.left + axis.width, corner.y + height},
                     ImGui::GetColorU32(ImGuiCol_FrameBg));
  constexpr double kTurnsOver_deg = 180.0;  // an angle that wraps around is not a line
  for (int c = 0; c < 3; ++c)
    for (std::size_t i = 1; i < samples.size(); ++i) {
      const double from = samples[i - 1][c], to = samples[i][c];
      if (settings.curve == ChannelKind::rotation && std::abs(to - from) > kTurnsOver_deg) continue;
      const float step = axis.width / static_cast<float>(samples.size() - 1);
      const float x = axis.left + step * static_cast<float>(i);
      draw.AddLine({x - step, y_of(from)}, {x, y_of(to)}, kAxes[c], 1.5f);
    }
  for (const Channel& channel : channels)
    if (channel.kind == settings.curve && channel.owner == settings.inspected.joint)
      for (const double time : channel.times_s)
        for (int c = 0; c < 3; ++c) draw.AddCircleFilled({axis.x(time), y_of(value(time)[c])}, 3.0f, kAxes[c], 8);
  draw_now(axis, playback.time_s(), corner.y, corner.y + height);
  ImGui::SetCursorScreenPos(corner);
  ImGui::Dummy({1.0f, height});
}

}  // namespace

FreePart lay_out_timeline(const PanelFacts& facts, Settings& settings, Playback& playback, FreePart free) {
  if (facts.scene->animations.empty() && playback.duration_s() == 0.0) return free;
  const ImVec2 room = ImGui::GetIO().DisplaySize;
  const float unit = ImGui::GetFontSize();
  const auto place = [room](double side) { return 0.5f * room.x * static_cast<float>(1.0 + side); };
  const float left = place(free.left) + unit, width = place(free.right) - left - unit;
  ImGui::SetNextWindowPos({left, room.y - 0.5f * unit}, ImGuiCond_Always, {0.0f, 1.0f});
  ImGui::SetNextWindowSizeConstraints({width, 0.0f}, {width, std::max(0.6f * room.y, 4.0f * unit)});
  const ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                 ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoFocusOnAppearing |
                                 ImGuiWindowFlags_AlwaysAutoResize;
  if (ImGui::Begin("timeline", nullptr, flags)) {
    play_controls(facts, settings, playback);
    const std::vector<Channel> channels = channels_of(*facts.scene, playback.clip());
    const bool rows = settings.timeline_keys && !channels.empty();
    TimeAxis axis;
    axis.left = ImGui::GetCursorScreenPos().x + (rows ? std::min(14.0f * unit, 0.4f * width) : 0.0f);
    axis.width = std::max(1.0f, ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x - axis.left -
                                    (rows ? ImGui::GetStyle().ScrollbarSize : 0.0f));
    axis.duration_s = std::max(playback.duration_s(), 1e-6);
    if (!facts.graph) ruler(settings, playback, all_key_times(channels), axis);
    if (rows) channel_rows(facts, settings, playback, channels, axis, 6.5f * unit);
    if (rows && settings.inspected.joint < facts.scene->skeleton.joint_count())
      curve(facts, settings, playback, channels, axis, 6.5f * unit);
  }
  free.bottom = 1.0 - 2.0 * static_cast<double>(ImGui::GetWindowPos().y / room.y);
  ImGui::End();
  constexpr double kTooHigh = 0.2;  // more than 60 % of the window: the scene uses the whole height, behind it
  if (!(free.bottom < kTooHigh)) free.bottom = -1.0;
  return free;
}

}  // namespace sinew::viewer
