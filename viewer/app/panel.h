// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "runtime/plan/needs.h"
#include "viewer/app/live_plan.h"
#include "viewer/app/playback.h"
#include "viewer/app/settings.h"
#include "viewer/passes/frame_renderer.h"

namespace sinew::viewer {

/// What the panel tells.
struct PanelFacts {
  std::string_view name, note, device;
  const Scene* scene = nullptr;
  const Needs* needs = nullptr;
  std::string updates;                    ///< how often poses are evaluated, and why
  std::span<const PlanRow> rows;          ///< of the live plan
  bool resting = false;                   ///< nothing moves: no pose is evaluated
  double frame_ms = 0.0;                  ///< from one picture to the next, smoothed
  std::span<const std::string> exhibits;  ///< names to choose from; fewer than two = no choice is offered
  std::uint32_t exhibit = 0;
};

/// What the user asked for besides changing settings and playback.
struct PanelWishes {
  bool frame_all = false;
  std::optional<std::uint32_t> exhibit;
};

/// Lays out the panel with ImGui calls; settings and playback change where the user changes them. Needs an ImGui frame
/// that was begun, no device.
PanelWishes lay_out_panel(const PanelFacts& facts, Settings& settings, Playback& playback);

}  // namespace sinew::viewer
