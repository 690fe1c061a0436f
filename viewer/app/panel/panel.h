// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "runtime/plan/needs.h"
#include "viewer/app/cache/cache_facts.h"
#include "viewer/app/camera/orbit_camera.h"
#include "viewer/app/live_plan.h"
#include "viewer/app/playback.h"
#include "viewer/app/settings.h"
#include "viewer/passes/frame_renderer.h"

namespace sinew::viewer {

/// Data that the panel shows.
struct PanelFacts {
  std::string_view name, note, device;
  std::span<const std::string> messages;  ///< warnings of the shown files, and of files that were dropped
  std::string_view reload_fault;          ///< why the changed file is not shown; empty = it is shown
  const Scene* scene = nullptr;
  const Needs* needs = nullptr;
  const CharacterRig* rig = nullptr;  ///< null = none
  GraphPlayer* graph = nullptr;       ///< graph that drives the character; null = clips play. The panel sets parameters
  const FrameResult* pose = nullptr;  ///< the newest; null = none
  PoseProgramSpan program;            ///< of the last pose; empty while the clip plays alone
  std::string updates;                ///< update rate of the poses, and the reason for it
  std::optional<CacheFacts> cache;    ///< unset = no geometry cache plays
  std::span<const PlanRow> rows;      ///< rows of the live plan
  bool resting = false;               ///< nothing moves, so no pose is evaluated
  bool has_visibility = false;        ///< the scene has per-vertex ambient visibility
  double frame_ms = 0.0;              ///< smoothed time between pictures
  std::span<const std::string> scene_names;  ///< the menu appears if there are at least two
  std::uint32_t scene_index = 0;
};

/// User requests that are not applied to settings or playback directly.
struct PanelRequests {
  bool frame_all = false;
  std::optional<std::uint32_t> scene;
  FreePart free;  ///< the wider part of the window beside the panel, above the timeline; everything if both are hidden
};

/// Lays out the panel with ImGui calls, and applies what the user changes to settings and playback. An ImGui frame must
/// have begun; no device is needed.
PanelRequests lay_out_panel(const PanelFacts& facts, Settings& settings, Playback& playback);

}  // namespace sinew::viewer
