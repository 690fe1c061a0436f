// SPDX-License-Identifier: MIT
#pragma once
#include <functional>
#include <memory>
#include <span>
#include <string_view>

#include "viewer/device/device.h"
#include "viewer/passes/occlusion_shape.h"
#include "viewer/passes/pass_stages.h"
#include "viewer/passes/render_options.h"
#include "viewer/passes/view.h"
#include "viewer/upload/frame_upload.h"
#include "viewer/upload/scene_upload.h"

namespace sinew::viewer {

/// Where a frame is drawn. The image's old contents do not matter; it must allow colour attachment use. A UNORM format
/// receives sRGB-encoded values from the shader, an SRGB format is encoded by the hardware.
struct ColorTarget {
  VkImage image = VK_NULL_HANDLE;
  VkImageView view = VK_NULL_HANDLE;
  VkExtent2D extent{};
  VkImageLayout final_layout = VK_IMAGE_LAYOUT_PRESENT_SRC_KHR;  ///< left in this layout, visible to all later commands
};

/// A scene that was uploaded and the vertices of its newest frame.
struct DrawnScene {
  const SceneUpload* scene = nullptr;
  const FrameUpload* frame = nullptr;
  std::uint32_t variant = kNone;  ///< of the scene's material variants, kNone = the materials of the primitives
};

/// End points of a line drawn over the picture, without depth test: the skeleton, a grid. Two vertices per line.
struct LineVertex {
  glm::vec3 position;                ///< world space
  std::uint32_t rgba = 0xffffffffu;  ///< 8 bits each, red lowest, sRGB
};

/// Everything that one frame shows.
struct FrameInputs {
  std::uint32_t slot = 0;  ///< < slot count; the GPU must be done with its last use
  std::span<const DrawnScene> scenes;
  View view;
  RenderOptions options;
  std::span<const LineVertex> lines;
  std::function<void(VkCommandBuffer)> overlay;  ///< recorded last, inside rendering to the target: the ImGui hook
};

/// Milliseconds that a pass took on the GPU.
struct PassTime {
  std::string_view pass;
  double milliseconds = 0.0;
};

/// What a frame drew and what it left out, for people who look.
struct FrameReport {
  std::array<PassStage, kPassCount> passes{};
  std::uint32_t drawn = 0, out_of_view = 0;  ///< draws of primitives, counted for each copy
  std::uint32_t hidden = 0;                  ///< mesh instances that are not shown
  double collect_us = 0.0;                   ///< time that choosing the draws took
};

/// Records the passes of a frame in the order of frame_graph.h, each only when the frame calls for it.
///
/// Use:  wait until the slot's last submit is done;  frame_upload.update(slot, result);
///       scene_upload.update(slot, frame_upload.look(slot));
///       renderer.record(commands, target, inputs);  submit `commands`, waiting for the target at
///       COLOR_ATTACHMENT_OUTPUT
/// owns  pipelines, the images between passes (made again when the target's extent changes: waits for the device then),
///       and per slot uniforms, descriptor sets and timestamps.   thread: one
class FrameRenderer {
 public:
  /// in   target_format  of every ColorTarget;   slot_count  frames that may be in flight
  FrameRenderer(Device& device, VkFormat target_format, std::uint32_t slot_count, const OcclusionShape& occlusion = {});
  ~FrameRenderer();
  FrameRenderer(const FrameRenderer&) = delete;
  FrameRenderer& operator=(const FrameRenderer&) = delete;

  /// in   commands  begun, outside of rendering
  void record(VkCommandBuffer commands, const ColorTarget& target, const FrameInputs& inputs);

  /// Times of the passes that the slot's last frame ran, once the GPU is done with it. Empty without timestamps.
  std::span<const PassTime> pass_times(std::uint32_t slot);

  /// Of the slot's last frame.
  const FrameReport& report(std::uint32_t slot) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sinew::viewer
