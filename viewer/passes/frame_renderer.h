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
#include "viewer/upload/access_blend.h"
#include "viewer/upload/frame_upload.h"
#include "viewer/upload/scene_upload.h"

namespace sinew::viewer {

/// The image that a frame is drawn to. It must allow use as a colour attachment; its old contents are discarded. For a
/// UNORM format the shader encodes to sRGB, for an SRGB format the hardware does.
struct ColorTarget {
  VkImage image = VK_NULL_HANDLE;
  VkImageView view = VK_NULL_HANDLE;
  VkExtent2D extent{};
  VkImageLayout final_layout =
      VK_IMAGE_LAYOUT_PRESENT_SRC_KHR;  ///< the layout after drawing; visible to all later commands
};

/// An uploaded scene and the vertices of its newest frame.
struct DrawnScene {
  const SceneUpload* scene = nullptr;
  const FrameUpload* frame = nullptr;
  std::uint32_t variant = kNone;  ///< material variant of the scene, kNone = the materials of the primitives
  AccessBlend access = {};        ///< of ambient access at the vertices
};

/// End point of a line that is drawn over the picture, fainter behind surfaces and far away. Two vertices a line, which
/// has the colour of the first.
struct LineVertex {
  glm::vec3 position;                ///< world space
  std::uint32_t rgba = 0xffffffffu;  ///< 8 bits each, red lowest, sRGB
};

/// Everything that one frame shows.
struct FrameInputs {
  std::uint32_t slot = 0;  ///< below the slot count; the GPU must be done with its last use
  std::span<const DrawnScene> scenes;
  View view;
  RenderOptions options;
  std::span<const LineVertex> lines;
  std::function<void(VkCommandBuffer)> overlay;  ///< recorded last, while rendering to the target
};

/// Milliseconds that a pass took on the GPU.
struct PassTime {
  std::string_view pass;
  double milliseconds = 0.0;
};

/// What a frame drew and what it left out, for the live plan.
struct FrameReport {
  std::array<PassStage, kPassCount> passes{};
  std::array<PictureMode, kModeCount> modes{};
  std::uint32_t drawn = 0, out_of_view = 0;  ///< primitives, counted for each copy
  std::uint32_t hidden = 0;                  ///< mesh instances on hidden nodes
  double collect_us = 0.0;                   ///< time to collect the draws
};

/// Records the passes of a frame in the order of frame_graph.h; a pass that the frame does not need is left out.
///
/// Use:  wait until the slot's last submit is done;  frame_upload.update(slot, result);
///       scene_upload.update(slot, frame_upload.look(slot));
///       renderer.record(commands, target, inputs);  submit `commands`, waiting for the target at
///       COLOR_ATTACHMENT_OUTPUT
/// owns  pipelines, the images between passes, and per slot uniforms, descriptor sets and timestamps. When the extent
/// of
///       the target changes, it waits for the device and creates the images again.   thread: one
class FrameRenderer {
 public:
  /// in   target_format  of every ColorTarget;   slot_count  most frames in flight
  FrameRenderer(Device& device, VkFormat target_format, std::uint32_t slot_count, const OcclusionShape& occlusion = {});
  ~FrameRenderer();
  FrameRenderer(const FrameRenderer&) = delete;
  FrameRenderer& operator=(const FrameRenderer&) = delete;

  /// in   commands  in recording state, outside of rendering
  void record(VkCommandBuffer commands, const ColorTarget& target, const FrameInputs& inputs);

  /// Times of the passes of the slot's last frame; the GPU must be done with it. Empty without timestamps.
  std::span<const PassTime> pass_times(std::uint32_t slot);

  /// Report of the slot's last frame.
  const FrameReport& report(std::uint32_t slot) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sinew::viewer
