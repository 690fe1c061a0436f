// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "viewer/passes/render_options.h"

namespace sinew::viewer {

enum class Pass : std::uint8_t {
  shadow,        ///< depth as lights see it
  normal_depth,  ///< view-space normals and depth of everything opaque
  ssao,          ///< ambient access: how much ambient light arrives; at half size
  blur_horizontal,
  blur_vertical,
  opaque,
  outline,  ///< of Gooch shading: lines at silhouettes and creases
  ground,   ///< shadows and contact on a level ground, and its grid
  behind,   ///< what is drawn so far in ever smaller copies, for rough surfaces that let light through
  transparent,
  weighted,  ///< weighted sums of blended surfaces, which lie over the picture where that is read
  exposure,  ///< automatic: from the light of the picture
  tonemap,
  show,    ///< one of the buffers instead of the picture
  overlay  ///< lines and the panel
};
inline constexpr std::size_t kPassCount = 15;

std::string_view name_of(Pass pass) noexcept;

/// What a frame contains and what was asked for.
struct FrameNeeds {
  bool opaque = false;    ///< something opaque or masked is visible
  bool blended = false;   ///< something is visible that is drawn from far to near
  bool frosted = false;   ///< some of it is rough and lets light through
  bool weighted = false;  ///< something is visible that blends in any order
  bool overlay = false;   ///< lines or a panel
  bool lines = false;
  bool unlit = false;  ///< something is visible whose colours are shown as the file has them, or as Gooch shades them
  bool gooch = false;  ///< Gooch shading: no light is counted, so shadows, ambient light and occlusion are left out
  std::uint32_t shadows = 0;  ///< lights that cast them
  bool ambient = true;        ///< there is ambient light
  bool occlusion = true;      ///< ambient occlusion is switched on, not of strength 0, and looked for in screen space
  bool horizons = false;      ///< and by horizons, which know where the light comes from
  bool baked = false;         ///< ambient access comes with the vertices; then `occlusion` is false
  bool blur = true;
  bool auto_exposure = false;
  bool ground = false;        ///< it is switched on and seen from above
  bool grid = false;          ///< with lines, which are as bright whatever the exposure
  bool smooth_edges = false;  ///< 4 samples a pixel
  Show show = Show::color;

  /// Some pass reads the shadow map.
  bool shadowed() const noexcept {
    return shadows > 0 && show == Show::color && (opaque || blended || weighted || ground);
  }

  /// Some surface shows what is behind it, blurred.
  bool blurs_behind() const noexcept { return frosted && !gooch && show == Show::color; }

  /// Some pass reads normals and depth to draw lines.
  bool outlined() const noexcept { return opaque && gooch && show == Show::color; }

  /// Lines are fainter behind surfaces: they read depth.
  bool hides_lines() const noexcept { return lines && opaque; }

  /// Some pass reads ambient access.
  bool occluded() const noexcept {
    return opaque && occlusion && (show == Show::ao || (show == Show::color && ambient));
  }

  /// Some pass reads bent normals: reflections of the ambient light.
  bool bent() const noexcept { return occluded() && horizons && show == Show::color; }

  /// Some pass reads ambient access of the vertices.
  bool reads_baked() const noexcept {
    return (opaque || blended || weighted) && baked && (show == Show::ao || (show == Show::color && ambient));
  }
};

/// The passes of a frame in order, and the images between them. What the frame does not need does not exist.
class FrameGraph {
 public:
  explicit FrameGraph(const FrameNeeds& needs) noexcept;

  bool has(Pass pass) const noexcept;
  const Pass* begin() const noexcept { return passes_.data(); }
  const Pass* end() const noexcept { return passes_.data() + count_; }
  std::size_t size() const noexcept { return count_; }

  bool depth_image = false, normal_image = false, color_image = false;
  std::uint32_t shadow_maps = 0;
  bool exposure_image = false;
  bool behind_image = false;     ///< with an unlit image one of unlit colours, too
  bool weighted_images = false;  ///< sums of colours and weights, and coverage; with an unlit image unlit sums, too
  bool unlit_image = false;      ///< colours that no tone curve changes, beside the colour image
  bool vertex_access = false;    ///< vertices bring their ambient access
  bool ground_occluded = false;  ///< the prepass draws the ground, too, since ambient access is asked for there
  bool sampled = false;          ///< colour and depth of 4 samples a pixel, averaged into the colour image
  bool bent_normals = false;     ///< the image of ambient access has bent normals, too
  bool ao_image = false,
       half_blurred_ao = false;  ///< ambient access: the result, and after the first of two blur passes

 private:
  void add(Pass pass) noexcept { passes_[count_++] = pass; }

  std::array<Pass, kPassCount> passes_{};
  std::size_t count_ = 0;
};

}  // namespace sinew::viewer
