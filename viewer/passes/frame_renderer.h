// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <memory>
#include <span>
#include <string_view>

#include "viewer/device/device.h"
#include "viewer/passes/occlusion_shape.h"
#include "viewer/passes/pass_stages.h"
#include "viewer/passes/picture_modes.h"
#include "viewer/passes/render_options.h"
#include "viewer/passes/view.h"
#include "viewer/upload/frame_upload.h"
#include "viewer/upload/scene_upload.h"
#include "viewer/upload/visibility_blend.h"

namespace sinew::viewer {

/// The image that a frame is drawn to. It needs usage COLOR_ATTACHMENT; old contents are discarded. Shaders encode to
/// sRGB for UNORM formats; the hardware does for SRGB formats.
struct ColorTarget {
  VkImage image = VK_NULL_HANDLE;
  VkImageView view = VK_NULL_HANDLE;
  VkExtent2D extent{};
  VkImageLayout final_layout =
      VK_IMAGE_LAYOUT_PRESENT_SRC_KHR;  ///< layout after drawing, visible to all later commands
};

/// A scene to draw: its static data and the vertices of its newest frame.
struct DrawnScene {
  const SceneUpload* scene = nullptr;
  const FrameUpload* frame = nullptr;
  std::uint32_t variant = kNone;    ///< index of a material variant; kNone = the default materials
  VisibilityBlend visibility = {};  ///< key poses of per-vertex ambient visibility
};

/// End point of an overlay line; two vertices make a line, in the colour of the first. Lines are fainter behind
/// surfaces and far away.
struct LineVertex {
  glm::vec3 position;                ///< world space
  std::uint32_t rgba = 0xffffffffu;  ///< sRGB, 8 bits per channel, red in the lowest byte
};

/// All inputs of one frame.
struct FrameInputs {
  std::uint32_t slot = 0;  ///< below the slot count; the GPU must have finished its last use
  std::span<const DrawnScene> scenes;
  View view;
  RenderOptions options;
  std::span<const LineVertex> lines;
  std::function<void(VkCommandBuffer)> overlay;  ///< recorded last, inside the render pass of the target
};

/// GPU time of a pass.
struct PassTime {
  std::string_view pass;
  double milliseconds = 0.0;
};

/// Statistics of a frame for the live plan: what it drew, what it skipped, and why.
struct FrameReport {
  std::array<PassStage, kPassCount> passes{};
  std::array<PictureMode, kModeCount> modes{};
  std::uint32_t drawn = 0, out_of_view = 0;  ///< primitives, counted for each copy
  std::uint32_t hidden = 0;                  ///< mesh instances on hidden nodes
  double collect_us = 0.0;                   ///< CPU time to collect the draws
};

/// Records the passes of a frame in the order of frame_graph.h. Skips passes that the frame does not need.
///
/// Use:  wait until the slot's last submit is done;  frame_upload.update(slot, result);
///       scene_upload.update(slot, frame_upload.look(slot));
///       renderer.record(commands, target, inputs);  submit `commands`, waiting for the target at
///       COLOR_ATTACHMENT_OUTPUT
/// owns  pipelines, the images between passes, and for each slot uniforms, descriptor sets and timestamps. When the
///       extent of the target changes, it waits for the device and recreates the images.   thread: one
class FrameRenderer {
 public:
  /// in   target_format  format of every ColorTarget;   slot_count  largest number of frames in flight
  FrameRenderer(Device& device, VkFormat target_format, std::uint32_t slot_count, const OcclusionShape& occlusion = {});
  ~FrameRenderer();
  FrameRenderer(const FrameRenderer&) = delete;
  FrameRenderer& operator=(const FrameRenderer&) = delete;

  /// in   commands  in recording state, outside a render pass
  void record(VkCommandBuffer commands, const ColorTarget& target, const FrameInputs& inputs);

  /// GPU times of the slot's last frame, which the GPU must have finished. Empty if the queue has no timestamps.
  std::span<const PassTime> pass_times(std::uint32_t slot);

  /// Statistics of the slot's last frame.
  const FrameReport& report(std::uint32_t slot) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sinew::viewer
