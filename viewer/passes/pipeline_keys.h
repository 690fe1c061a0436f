// SPDX-License-Identifier: MIT
#pragma once
#include <compare>
#include <cstdint>

#include "viewer/passes/draw_list.h"
#include "viewer/passes/frame_graph.h"
#include "viewer/passes/render_options.h"

namespace sinew::viewer {

/// Properties of a frame that select shader variants, as specialisation constants. They are not uniforms, because
/// software drivers recompile a shader for each value of a uniform that it branches on.
struct FrameFeatures {
  bool occluded = false, bent = false;  ///< an ambient visibility image exists; it also holds bent normals
  bool vertex_visibility = false;       ///< ambient visibility is a vertex attribute
  bool parallel = false;                ///< orthographic projection
  bool transparent_background = false;
  bool ambient = false;             ///< environment light is present
  std::uint32_t shadow_lights = 0;  ///< bit i set = light i casts shadows
  ToneCurve tone_curve = ToneCurve::neutral;
  Backdrop backdrop = Backdrop::plain;
  bool auto_exposure = false;       ///< an exposure image exists
  bool unlit_image = false;         ///< an image for display colours that bypass the tone curve exists
  bool weighted = false;            ///< weighted sums exist
  bool gooch = false;               ///< Gooch shading
  bool shows_level = false;         ///< the prepass writes levels of textures instead of normals
  bool quaternion_normals = false;  ///< normals and tangent frames are interpolated as quaternions
  bool smooth_edges = false;        ///< opaque and transparent passes use 4x multisampling
  std::uint32_t light_count = 0;

  auto operator<=>(const FrameFeatures&) const = default;
};

/// Cells of the blurred backdrop. Its light is computed at their corners and interpolated in between.
inline constexpr std::uint32_t kBackdropColumns = 64, kBackdropRows = 36;

/// True if the backdrop is computed at corners of cells. Automatic exposure is known in fragment shaders alone.
constexpr bool blurs_at_corners(const FrameFeatures& frame) noexcept {
  return frame.backdrop == Backdrop::blurred && !frame.auto_exposure;
}

/// The steps of drawing a transmissive surface. First its colour multiplies the picture behind it, then its own light
/// is added.
enum class Through : std::uint8_t {
  nothing,           ///< not transmissive: drawn in one step
  filter,            ///< first step over a plain backdrop: darkens the surfaces behind it and the backdrop
  filter_drawn,      ///< first step over an environment, which is drawn later: darkens only the surfaces behind it
  blurred_backdrop,  ///< second step: adds the blurred environment, where no surface is behind it
  sharp_backdrop,    ///< second step: adds the sharp environment, where no surface is behind it
  light,             ///< last step: adds the surface's own light
  erase,             ///< first step of a rough surface: removes the sharp picture behind it
  frosted,           ///< last step of a rough surface: adds its own light and the blurred opaque picture
  frosted_blurred,   ///< frosted, plus the blurred environment where no surface is behind it
  frosted_sharp      ///< frosted, plus the sharp environment where no surface is behind it
};

/// Key of a pipeline that draws meshes.
struct MeshPipelineKey {
  Pass pass = Pass::opaque;  ///< normal_depth, opaque, transparent or weighted
  Topology topology = Topology::triangles;
  bool masked = false;
  bool covers = false;  ///< Pass::transparent: a transmissive surface that covers its pixels whatever its alpha
  Through through = Through::nothing;
  bool after_prepass = false;  ///< opaque: depth is written already, the test is EQUAL
  bool depth_only = false;     ///< normal_depth, shadow; opaque: the depth of the samples
  FrameFeatures frame;
  SurfaceFeatures surface;

  auto operator<=>(const MeshPipelineKey&) const = default;
};

/// Key of a pipeline without meshes: full-screen passes, the ground and its prepass, overlay lines.
struct ScreenPipelineKey {
  Pass pass = Pass::tonemap;
  Show show = Show::color;            ///< for Pass::show: the buffer to show
  bool sums = false;                  ///< Pass::exposure: the first of its steps
  bool grid = false, behind = false;  ///< Pass::ground; behind = under the resolved picture (FrameGraph::ground_behind)
  OcclusionMethod occlusion = OcclusionMethod::gtao;  ///< for Pass::ssao
  FrameFeatures frame;

  auto operator<=>(const ScreenPipelineKey&) const = default;
};

}  // namespace sinew::viewer
