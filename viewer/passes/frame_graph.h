// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "viewer/passes/render_options.h"

namespace sinew::viewer {

enum class Pass : std::uint8_t {
  shadow,        ///< shadow maps: depth as seen from lights
  normal_depth,  ///< prepass: view-space normals and depth of opaque surfaces
  ssao,          ///< ambient visibility (1 = no occlusion) at half size, by either method
  blur_horizontal,
  blur_vertical,
  opaque,
  outline,  ///< Gooch shading only: lines at silhouettes and creases
  ground,   ///< shadows, contact occlusion and grid of the ground plane
  behind,   ///< mip levels of the opaque picture, for rough transmissive surfaces
  transparent,
  weighted,  ///< weighted sums of blended surfaces; later passes composite them when they read the picture
  exposure,  ///< automatic exposure, from the brightness of the picture
  backdrop,  ///< the environment behind the scene
  tonemap,
  show,    ///< shows an intermediate buffer instead of the picture
  overlay  ///< lines and the panel
};
inline constexpr std::size_t kPassCount = 16;

std::string_view name_of(Pass pass) noexcept;

/// Why a frame has no ground.
enum class NoGround : std::uint8_t {
  not_asked,       ///< it is off, or the eye is below it
  nothing_darkens  ///< no shadow falls on it in view, and nothing near it hides ambient light
};

/// Content of a frame and requested options; FrameGraph derives the passes from it.
struct FrameNeeds {
  bool opaque = false;    ///< an opaque or masked surface is visible
  bool blended = false;   ///< a surface that is drawn sorted from far to near is visible
  bool frosted = false;   ///< one of these is rough and transmissive
  bool weighted = false;  ///< a surface that blends with weighted sums is visible
  bool overlay = false;   ///< lines or a panel
  bool lines = false;
  bool unlit = false;         ///< a visible surface writes display colours without lighting: unlit or Gooch
  bool gooch = false;         ///< Gooch shading: no shadows, ambient light or occlusion
  std::uint32_t shadows = 0;  ///< number of lights that cast shadows
  bool ambient = true;        ///< environment light is present
  bool occlusion = true;      ///< screen-space ambient occlusion is on and has an effect
  bool horizons = false;      ///< it uses horizons (gtao), which also give bent normals
  bool baked = false;         ///< ambient visibility is a vertex attribute; then `occlusion` is false
  bool blur = true;
  bool auto_exposure = false;
  bool ground = false;         ///< the ground is seen from above and something darkens it, or it has a grid
  bool ground_touched = true;  ///< something near the ground may hide ambient light from it
  NoGround no_ground = NoGround::not_asked;  ///< why there is no ground, if `ground` is false
  bool grid = false;                         ///< the ground has grid lines, whose brightness is independent of exposure
  bool smooth_edges = false;                 ///< 4 samples a pixel
  bool backdrop = false;                     ///< the environment is seen behind the scene
  bool shadows_kept = false;                 ///< the shadow maps of an earlier frame still hold
  Show show = Show::color;

  /// True if the scene's images have something to show.
  bool draws() const noexcept { return opaque || blended || weighted || ground; }

  /// True if a pass reads shadow maps.
  bool shadowed() const noexcept {
    return shadows > 0 && show == Show::color && (opaque || blended || weighted || ground);
  }

  /// True if a surface shows a blurred picture of what is behind it.
  bool blurs_behind() const noexcept { return frosted && !gooch && show == Show::color; }

  /// True if the outline pass runs; it reads normals and depth.
  bool outlined() const noexcept { return opaque && gooch && show == Show::color; }

  /// True if lines read depth, because they are fainter behind surfaces.
  bool hides_lines() const noexcept { return lines && opaque; }

  /// True if a pass reads screen-space ambient visibility.
  bool occluded() const noexcept {
    return opaque && occlusion && (show == Show::ao || (show == Show::color && ambient));
  }

  /// True if a pass reads bent normals, for reflections of environment light.
  bool bent() const noexcept { return occluded() && horizons && show == Show::color; }

  /// True if a pass reads per-vertex ambient visibility.
  bool reads_baked() const noexcept {
    return (opaque || blended || weighted) && baked && (show == Show::ao || (show == Show::color && ambient));
  }
};

/// The passes of a frame in order, and the images between them. Contains only what the frame needs.
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
  bool behind_image = false;       ///< mip levels of the opaque picture; with unlit_image, also of unlit colours
  bool weighted_images = false;    ///< sums of colours and weights, and coverage; with unlit_image, also unlit sums
  bool unlit_image = false;        ///< display colours that bypass the tone curve
  bool vertex_visibility = false;  ///< ambient visibility is a vertex attribute
  bool ground_occluded = false;    ///< the prepass also draws the ground, which needs ambient visibility
  bool ground_behind = false;      ///< the ground is drawn behind the resolved picture, with one sample a pixel
  bool sampled = false;            ///< 4x multisampling; colours are resolved into the colour image
  bool bent_normals = false;       ///< the ambient visibility image also holds bent normals
  bool ao_image = false,
       half_blurred_ao = false;  ///< images of ambient visibility: the result, and the state after the first blur pass

 private:
  void add(Pass pass) noexcept { passes_[count_++] = pass; }

  std::array<Pass, kPassCount> passes_{};
  std::size_t count_ = 0;
};

}  // namespace sinew::viewer
