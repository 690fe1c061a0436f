// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/plan/needs.h"
#include "viewer/app/clip_extent.h"
#include "viewer/app/inspect/inspected.h"
#include "viewer/app/loaded_scene.h"
#include "viewer/app/options.h"
#include "viewer/app/timeline/channels.h"
#include "viewer/passes/render_options.h"

namespace sinew::viewer {

/// All that the user can change while the window is open, except clip and time (Playback).
struct Settings {
  Show show = Show::color;
  Shading shading = Shading::physical;
  NormalInterpolation normals = NormalInterpolation::interpolated;
  Transparency transparency = Transparency::sorted;
  bool ambient_occlusion = true;
  OcclusionMethod occlusion_method = AmbientOcclusion{}.method;
  bool shadows = true;
  GroundLook ground = GroundLook::shadows;
  bool smooth_edges = true;
  Backdrop backdrop = Backdrop::plain;
  ToneCurve tone_curve = ToneCurve::aces;
  float environment_turn_deg = 0.0f, environment_intensity = 1.0f, exposure_ev = 0.0f;
  bool auto_exposure = false;
  bool skeleton = false;
  bool panel = true;
  bool plan = false;  ///< show the live plan next to the panel

  bool timeline_keys = false;                 ///< the timeline lists all channels with their keys
  bool counts_frames = false;                 ///< the timeline counts frames of Playback::kFrame_s instead of seconds
  Inspected inspected;                        ///< joint and vertex that are looked at
  bool inside = false;                        ///< show the nodes of the scene and what is inspected
  ChannelKind curve = ChannelKind::rotation;  ///< the curve of that joint in the timeline

  /// True if the live plan is visible: it hides together with the panel.
  bool shows_plan() const noexcept { return panel && plan; }

  Skinning skinning = Skinning::linear;
  Updates updates = Updates::interpolated;
  Framing framing = Framing::clip;
  std::uint32_t camera = kNone;   ///< index in Scene::cameras; kNone = the user's orbit camera
  std::uint32_t variant = kNone;  ///< index in Scene::variants; kNone = the default materials
  float cache_weight = 1.0f;      ///< [0, 1] 0 = the pose, 1 = the geometry cache

  MotionSettings motion;  ///< layers, root motion, springs and expressions

  /// in   rig  of the scene; null = it has none
  Evaluation evaluation(const CharacterRig* rig = nullptr) const {
    return {skinning, updates, shows_plan(), shape_of(motion, rig)};
  }

  /// Forgets choices that are indices into the scene: joint, vertex, camera, variant, layers, expressions, morph
  /// weights.
  void leave_scene();

  /// True if the picture needs joints even while no mesh is in view.
  bool needs_joints() const noexcept { return skeleton || inspected.draws_lines() || inside || camera != kNone; }

  friend bool operator==(const Settings&, const Settings&) = default;
};

/// Settings from the command line. Named cameras and variants that the scene lacks are ignored. A scene without meshes
/// always shows its skeleton, because there is nothing else to see.
Settings settings_from(const Options& options, const Scene& scene);

/// Switches between ambient occlusion alone and the lit picture.
void toggle_ao_only(Settings& settings) noexcept;

/// Shows the live plan together with the panel, or hides the live plan.
void toggle_plan(Settings& settings) noexcept;

/// Shows the nodes of the scene together with the panel, or hides them.
void toggle_inside(Settings& settings) noexcept;

/// Shows the keys of all channels in the timeline together with the panel, or hides them.
void toggle_keys(Settings& settings) noexcept;

/// Cycles through every, interpolated, held.
void next_updates(Settings& settings) noexcept;

/// Cycles through linear, dual quaternion, center of rotation.
void next_skinning(Settings& settings) noexcept;

/// Cycles through none, shadows, grid.
void next_ground(Settings& settings) noexcept;

/// Cycles through color, ao, normals, depth, level.
void next_show(Settings& settings) noexcept;

/// Converts settings to options of the renderer. Lengths, such as the occlusion radius, scale with the size of the
/// clip.
/// in   environment  of the scene; null = no environment light
RenderOptions render_options(const Settings& settings, std::shared_ptr<const Environment> environment,
                             const ClipExtent& bounds, const glm::dvec3& eye);

}  // namespace sinew::viewer
