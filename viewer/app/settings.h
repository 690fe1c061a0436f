// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/plan/needs.h"
#include "viewer/app/clip_extent.h"
#include "viewer/app/exhibit.h"
#include "viewer/app/options.h"
#include "viewer/passes/render_options.h"

namespace sinew::viewer {

/// What the user can switch while looking. Times and clips are in Playback.
struct Settings {
  Show show = Show::color;
  bool ambient_occlusion = true;
  bool skeleton = false;
  bool panel = true;
  bool plan = false;  ///< the live plan, beside the panel

  /// The live plan can be seen.
  bool watches_plan() const noexcept { return panel && plan; }

  Skinning skinning = Skinning::linear;
  Updates updates = Updates::interpolated;
  std::uint32_t camera = kNone;   ///< of the scene; kNone = the user's own
  std::uint32_t variant = kNone;  ///< of the scene's materials

  Evaluation evaluation() const noexcept { return {skinning, updates, watches_plan()}; }

  /// The picture takes joints even where no mesh is in view.
  bool watches_joints() const noexcept { return skeleton || camera != kNone; }

  friend bool operator==(const Settings&, const Settings&) = default;
};

/// A scene without meshes shows its skeleton, whatever the options say: there is nothing else to see. Camera and
/// variant are those that the options name, where the scene has them.
Settings settings_from(const Options& options, const Scene& scene);

/// Turns ambient occlusion only on, and back to the lit picture.
void toggle_ao_only(Settings& settings) noexcept;

/// Shows the live plan, with the panel beside which it stands, or hides it.
void toggle_plan(Settings& settings) noexcept;

/// Every frame; where meshes are small interpolated, or held; and again.
void next_updates(Settings& settings) noexcept;

/// Linear, dual quaternion, center of rotation, and again.
void next_skinning(Settings& settings) noexcept;

/// Color, ao, normals, depth, and again.
void next_show(Settings& settings) noexcept;

/// What the renderer takes for these settings, with lengths that follow the clip's size.
RenderOptions render_options(const Settings& settings, const ClipExtent& bounds, const glm::dvec3& eye);

}  // namespace sinew::viewer
