// SPDX-License-Identifier: MIT
#pragma once
#include <compare>
#include <cstdint>

#include "viewer/passes/draw_list.h"
#include "viewer/passes/frame_graph.h"
#include "viewer/passes/render_options.h"

namespace sinew::viewer {

/// What a frame has that shaders are compiled for. Each combination has its own pipelines, with the features as
/// specialisation constants. They are no uniforms, because drivers that run on the CPU compile a shader again for each
/// value of a uniform that it branches on.
struct FrameFeatures {
  bool occluded = false, bent = false;  ///< there is an ambient access image; it has bent normals, too
  bool vertex_access = false;           ///< vertices bring their ambient access
  bool parallel = false;                ///< parallel projection
  bool transparent_background = false;
  bool ambient = false;             ///< there is an environment
  std::uint32_t shadow_lights = 0;  ///< bit i is set: light i casts shadows
  ToneCurve tone_curve = ToneCurve::neutral;
  Backdrop backdrop = Backdrop::plain;
  bool auto_exposure = false;       ///< there is an image with the exposure
  bool unlit_image = false;         ///< there is an image for colours that no tone curve changes
  bool weighted = false;            ///< there are weighted sums
  bool gooch = false;               ///< Gooch shading
  bool shows_level = false;         ///< the prepass writes levels of textures instead of normals
  bool quaternion_normals = false;  ///< normals and frames are interpolated as quaternions
  bool smooth_edges = false;        ///< opaque and transparent passes draw 4 samples a pixel
  std::uint32_t light_count = 0;

  auto operator<=>(const FrameFeatures&) const = default;
};

/// The steps in which a surface that lets light through is drawn over what is behind it: its colour filters that, then
/// it adds its own light.
enum class Through : std::uint8_t {
  nothing,           ///< the surface is drawn at once
  filter,            ///< first step; a plain backdrop is darkened, too
  filter_drawn,      ///< first step before an environment, which is no part of the image yet
  blurred_backdrop,  ///< second step then: the environment through the surface, where nothing is drawn behind it
  sharp_backdrop,
  light,            ///< last step
  erase,            ///< first step of a rough surface: nothing is seen directly through it
  frosted,          ///< last step then: its own light, and what is opaque behind it, blurred
  frosted_blurred,  ///< the same with the environment, where nothing is drawn behind it
  frosted_sharp
};

/// The properties of a pipeline that draws meshes.
struct MeshPipelineKey {
  Pass pass = Pass::opaque;  ///< normal_depth, opaque, transparent or weighted
  Topology topology = Topology::triangles;
  bool masked = false;
  bool covers = false;  ///< transparent: alpha is no coverage
  Through through = Through::nothing;
  bool after_prepass = false;    ///< opaque: depth is written already, the test is EQUAL
  std::uint32_t shadow_map = 0;  ///< shadow: which one
  bool depth_only = false;       ///< normal_depth, shadow; opaque: the depth of the samples
  FrameFeatures frame;
  SurfaceFeatures surface;

  auto operator<=>(const MeshPipelineKey&) const = default;
};

/// The properties of a pipeline that covers the target, or draws the ground (or its prepass) or lines of the overlay.
struct ScreenPipelineKey {
  Pass pass = Pass::tonemap;
  Show show = Show::color;                            ///< Pass::show: which buffer
  bool sums = false;                                  ///< Pass::exposure: the first of its steps
  bool grid = false;                                  ///< Pass::ground
  OcclusionMethod occlusion = OcclusionMethod::gtao;  ///< Pass::ssao
  FrameFeatures frame;

  auto operator<=>(const ScreenPipelineKey&) const = default;
};

}  // namespace sinew::viewer
