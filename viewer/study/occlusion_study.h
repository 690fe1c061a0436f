// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "viewer/device/device.h"
#include "viewer/passes/occlusion_shape.h"
#include "viewer/passes/render_options.h"
#include "viewer/passes/view.h"
#include "viewer/study/ray_caster.h"

namespace sinew::viewer {

/// One way of making ambient occlusion, measured.
struct OcclusionTrial {
  std::string name, note;
  OcclusionShape shape;
  bool blur = true;
  bool is_default = false;
  double error = 0.0;                ///< root mean square difference of ambient access from ray casting, 0 to 1
  std::vector<double> milliseconds;  ///< of its passes on the device, one for each repetition; empty without timestamps
};

struct OcclusionStudy {
  std::string device;
  std::uint32_t width = 0, height = 0;
  std::uint64_t pixels = 0;    ///< that show a surface, and so count
  double error_without = 0.0;  ///< of a picture without ambient occlusion
  double radius_m = 0.0;
  std::vector<OcclusionTrial> trials;
};

/// How large the picture is, and how long to look.
struct OcclusionEffort {
  std::uint32_t width = 640, height = 400;
  int rays = 128;  ///< of each pixel's truth
  int repetitions = 15;
  bool every_way = true;  ///< else those that the questions are about: the driver compiles shaders for each

  static OcclusionEffort quick() { return {320, 200, 64, 7, false}; }
};

/// Draws one frame in each way and compares every pixel that shows a surface with what rays from there find.
/// Repetitions are in random order, so that a disturbance of the machine falls on all alike. err  DeviceError,
/// std::runtime_error      cost seconds to half a minute on a software device
OcclusionStudy study_occlusion(Device& device, const Scene& scene, const FrameResult& frame, const View& view,
                               const AmbientOcclusion& settings, const OcclusionEffort& effort);

/// Ambient access of every pixel by ray casting, rows from the top; negative where nothing is seen.
/// in   view  a perspective
std::vector<double> true_access(const RayCaster& rays, const View& view, std::uint32_t width, std::uint32_t height,
                                double radius_m, int ray_count);

}  // namespace sinew::viewer
