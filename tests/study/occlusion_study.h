// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "tests/study/ray_caster.h"
#include "tests/study/seen_pixels.h"
#include "viewer/device/device.h"
#include "viewer/passes/occlusion_shape.h"
#include "viewer/passes/render_options.h"
#include "viewer/passes/view.h"

namespace sinew::viewer {

struct PassTime;

/// Measurements of one way to compute ambient occlusion.
struct OcclusionTrial {
  std::string name, note;
  OcclusionMethod method = OcclusionMethod::ssao;
  OcclusionShape shape;
  bool blur = true;
  bool is_default = false;
  double error = 0.0;                ///< root mean square difference of ambient visibility from ray casting, in [0, 1]
  std::vector<double> milliseconds;  ///< GPU time of its passes, one for each repetition; empty without timestamps
};

/// Measurements of rays cast at vertices, before any picture is drawn (OcclusionMethod::rays).
struct VertexTrial {
  std::uint32_t rays = 0;     ///< per vertex
  double vertex_error = 0.0;  ///< root mean square difference of ambient visibility from 4,096 rays, over the vertices
  double error = 0.0;         ///< as OcclusionTrial::error: for the picture, in which triangles interpolate
  double seconds = 0.0;       ///< time to bake all vertices once
};

/// Measurements of a complete search for horizons (exhaustive_visibility()). Its remaining error comes from surfaces
/// that the picture does not show.
struct ExhaustiveTrial {
  double thickness = 0.0;  ///< assumed thickness of bodies, in radii
  double error = 0.0;      ///< as OcclusionTrial::error
};

struct OcclusionStudy {
  std::string device;
  std::uint32_t width = 0, height = 0;
  std::uint64_t pixels = 0;    ///< pixels that show a surface; only these are compared
  double error_without = 0.0;  ///< error of a picture without ambient occlusion
  double radius_m = 0.0;
  std::vector<OcclusionTrial> trials;
  std::vector<ExhaustiveTrial> exhaustive;  ///< empty without OcclusionEffort::exhaustive
  std::vector<VertexTrial> at_vertices;     ///< by rising number of rays; empty for more than 20,000 vertices
};

/// Size of the picture and number of repetitions.
struct OcclusionEffort {
  std::uint32_t width = 640, height = 400;
  int rays = 128;  ///< per pixel of the reference
  int repetitions = 15;
  bool every_way = true;   ///< false = only a few, because the driver compiles shaders for each
  bool exhaustive = true;  ///< also search for horizons completely, which takes seconds

  static OcclusionEffort quick() { return {320, 200, 64, 7, false, false}; }
};

/// Draws one frame in each way and compares each pixel that shows a surface with ray casting. The repetitions run in
/// random order, so that disturbances of the machine affect all ways alike.
/// err  DeviceError, std::runtime_error
/// cost seconds to half a minute on a software device
OcclusionStudy study_occlusion(Device& device, const Scene& scene, const FrameResult& frame, const View& view,
                               const AmbientOcclusion& settings, const OcclusionEffort& effort);

/// Time of a picture's ambient occlusion passes; std::nullopt without timestamps.
std::optional<double> occlusion_time_ms(std::span<const PassTime> times);

/// Ambient visibility of every pixel by ray casting; negative where no surface is visible.
std::vector<double> true_visibility(const RayCaster& rays, const SeenPixels& seen, double radius_m, int ray_count);

}  // namespace sinew::viewer
