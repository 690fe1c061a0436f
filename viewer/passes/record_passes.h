// SPDX-License-Identifier: MIT
#pragma once
#include "viewer/passes/draw_list.h"
#include "viewer/passes/frame_renderer.h"
#include "viewer/passes/pass_resources.h"

namespace sinew::viewer {

/// What recording a pass needs. All sizes and images fit the frame already.
struct PassContext {
  VkCommandBuffer commands;
  const FrameGraph& graph;
  FrameTargets& targets;
  PassPipelines& pipelines;
  VkPipelineLayout layout;
  const FrameSet& set;
  const DrawList& draws;
  const FrameInputs& inputs;
  const ColorTarget& target;
  VkBuffer lines;  ///< vertices in view space, 16 bytes each
  std::uint32_t line_vertices;
};

/// One function per pass, each in a file of its own name: barriers, attachments, draws.
void record_normal_depth(const PassContext& context);
void record_ssao(const PassContext& context);
void record_ssao_blur(const PassContext& context, bool vertical);
void record_opaque(const PassContext& context);
void record_transparent(const PassContext& context);
void record_tonemap(const PassContext& context);
void record_show(const PassContext& context);
void record_overlay(const PassContext& context);

/// The attachments of a pass. Dynamic rendering begins on construction and ends with the object.
struct Attachments {
  VkImageView color = VK_NULL_HANDLE;
  VkAttachmentLoadOp load = VK_ATTACHMENT_LOAD_OP_DONT_CARE;  ///< CLEAR = to zeros
  VkImageView depth = VK_NULL_HANDLE;
  bool depth_write = false;  ///< cleared and written; else loaded and only tested
  VkExtent2D extent{};
};

class Rendering {
 public:
  Rendering(VkCommandBuffer commands, const Attachments& attachments);
  ~Rendering() { vkCmdEndRendering(commands_); }
  Rendering(const Rendering&) = delete;
  Rendering& operator=(const Rendering&) = delete;

 private:
  VkCommandBuffer commands_;
};

/// Draws meshes; `key` is completed with each draw's topology and alpha test.
void draw_meshes(const PassContext& context, std::span<const Draw> draws, MeshPipelineKey key);

/// Binds the pipeline and the frame's set and covers the target with one triangle.
void draw_screen(const PassContext& context, VkPipeline pipeline, VkDescriptorSet set);

}  // namespace sinew::viewer
