// SPDX-License-Identifier: MIT
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "viewer/device/device.h"
#include "viewer/passes/occlusion_shape.h"
#include "viewer/passes/render_options.h"
#include "viewer/passes/view.h"
#include "tests/study/ray_caster.h"
#include "tests/study/seen_pixels.h"

namespace sinew::viewer {

struct PassTime;

/// One way to compute ambient occlusion, measured.
struct OcclusionTrial {
  std::string name, note;
  OcclusionMethod method = OcclusionMethod::ssao;
  OcclusionShape shape;
  bool blur = true;
  bool is_default = false;
  double error = 0.0;                ///< root mean square difference of ambient access from ray casting, in [0, 1]
  std::vector<double> milliseconds;  ///< GPU time of its passes, one for each repetition; empty without timestamps
};

/// Rays cast at vertices before any picture is drawn (OcclusionMethod::rays), measured.
struct VertexTrial {
  std::uint32_t rays = 0;     ///< a vertex
  double vertex_error = 0.0;  ///< root mean square difference of ambient access from 4,096 rays, over the vertices
  double error = 0.0;         ///< as OcclusionTrial::error: of the picture, in which triangles interpolate
  double seconds = 0.0;       ///< to bake all vertices once
};

/// Horizons with nothing overlooked (exhaustive_access()), measured: what remains is what a picture does not show.
struct ExhaustiveTrial {
  double thickness = 0.0;  ///< that bodies are taken to have, in radii
  double error = 0.0;      ///< as OcclusionTrial::error
};

struct OcclusionStudy {
  std::string device;
  std::uint32_t width = 0, height = 0;
  std::uint64_t pixels = 0;    ///< that show a surface; only these are compared
  double error_without = 0.0;  ///< of a picture without ambient occlusion
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
  bool every_way = true;   ///< false = a short list, because the driver compiles shaders for each
  bool exhaustive = true;  ///< also horizons with nothing overlooked, which takes seconds

  static OcclusionEffort quick() { return {320, 200, 64, 7, false, false}; }
};

/// Draws one frame in each way and compares each pixel that shows a surface with ray casting. The repetitions run in
/// random order, so that disturbances of the machine affect all ways alike.
/// err  DeviceError, std::runtime_error
/// cost seconds to half a minute on a software device
OcclusionStudy study_occlusion(Device& device, const Scene& scene, const FrameResult& frame, const View& view,
                               const AmbientOcclusion& settings, const OcclusionEffort& effort);

/// Time of the passes of ambient occlusion in a picture; nothing without timestamps.
std::optional<double> occlusion_time_ms(std::span<const PassTime> times);

/// Ambient access of every pixel by ray casting; negative where nothing is visible.
std::vector<double> true_access(const RayCaster& rays, const SeenPixels& seen, double radius_m, int ray_count);

}  // namespace sinew::viewer
