// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "runtime/plan/needs.h"
#include "viewer/app/cache/cache_facts.h"
#include "viewer/app/live_plan.h"
#include "viewer/app/orbit_camera.h"
#include "viewer/app/playback.h"
#include "viewer/app/settings.h"
#include "viewer/passes/frame_renderer.h"

namespace sinew::viewer {

/// What the panel shows.
struct PanelFacts {
  std::string_view name, note, device;
  std::string_view reload_fault;  ///< why the file as it is now is not shown; empty = it is
  const Scene* scene = nullptr;
  const Needs* needs = nullptr;
  std::string updates;                    ///< how often poses are evaluated, and why
  std::optional<CacheFacts> cache;        ///< none = no geometry cache plays
  std::span<const PlanRow> rows;          ///< the live plan
  bool resting = false;                   ///< nothing moves, so no pose is evaluated
  bool has_access = false;                ///< the exhibit has ambient access at its vertices
  double frame_ms = 0.0;                  ///< time from one picture to the next, smoothed
  std::span<const std::string> exhibits;  ///< names of the scenes; a choice is offered from two on
  std::uint32_t exhibit = 0;
};

/// What the user asked for, apart from changed settings and playback.
struct PanelWishes {
  bool frame_all = false;
  std::optional<std::uint32_t> exhibit;
  FreeWidth free;  ///< the wider part of the window beside the panel; all of it where that is closed or collapsed
};

/// Lays out the panel with ImGui calls, and applies what the user changes to settings and playback. An ImGui frame must
/// have begun; no device is needed.
PanelWishes lay_out_panel(const PanelFacts& facts, Settings& settings, Playback& playback);

}  // namespace sinew::viewer
