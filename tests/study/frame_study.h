// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string>
#include <vector>

#include "runtime/model/scene.h"
#include "runtime/plan/frame_result.h"
#include "viewer/app/clip_extent.h"
#include "viewer/device/device.h"
#include "viewer/passes/frame_renderer.h"

namespace sinew::viewer {

/// Size of the pictures, and number of repetitions.
struct FrameEffort {
  std::uint32_t width = 1280, height = 720;
  int repetitions = 10;
};

/// GPU times of the same picture, drawn repeatedly; none without timestamps.
struct PictureTimes {
  std::vector<double> opaque_ms, all_ms;  ///< of the opaque pass, and of all passes
  std::vector<std::string> ran;           ///< the passes of the last picture

  void add(std::span<const PassTime> passes);  ///< those of another picture
};

/// Many draws of small meshes with materials of their own, without and with ambient occlusion.
struct DrawTrial {
  std::uint32_t draws = 0;
  PictureTimes without, with;
};

/// Base features: ambient occlusion, the key light, a gradient of ambient light, one sample a pixel, no ground.
RenderOptions base_look(const ClipExtent& bounds);

/// The same with an environment, which is seen behind the scene, shadows, and 4 samples a pixel.
RenderOptions full_look(const ClipExtent& bounds);

/// A picture with base features, and a full one.
struct FrameTrial {
  std::string name;
  std::uint32_t draws = 0;
  std::uint64_t triangles = 0;
  PictureTimes base, full;
};

/// Both ways of a trial take turns, so that disturbances of the machine affect both alike. The first picture of each
/// does not count: the driver compiles shaders for it.
/// err  DeviceError
DrawTrial study_draws(Device& device, std::uint32_t draws, const FrameEffort& effort);
FrameTrial study_frame(Device& device, const std::string& name, const Scene& scene, const FrameResult& frame,
                       const ClipExtent& bounds, const FrameEffort& effort);

/// A doll of 19 parts with materials of their own, 43,776 triangles; and a ball of 100,352 triangles.
std::vector<FrameTrial> study_built_in_frames(Device& device, const FrameEffort& effort);

}  // namespace sinew::viewer
