// SPDX-License-Identifier: MIT
#pragma once
#include "viewer/passes/draw_list.h"
#include "viewer/passes/frame_renderer.h"
#include "viewer/passes/pass_resources.h"

namespace sinew::viewer {

/// Inputs for recording a pass. The intermediate images must exist and have the size of the target.
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
  FrameFeatures features;
  std::span<const ShadowView> shadow_views;  ///< [shadow maps]
  VkRect2D occluded;                         ///< texels of ambient occlusion that may show a surface
  VkRect2D drawn;     ///< pixels in which the scene may be drawn; the images of the scene are valid only there
  VkRect2D meshes;    ///< the part of it without the ground, if the ground is drawn behind the resolved picture
  VkRect2D contact;   ///< pixels of the ground that ambient occlusion may reach
  VkRect2D outlined;  ///< pixels in which outlines may be
  VkBuffer lines;     ///< vertices in view space, 16 bytes each
  std::uint32_t line_vertices;
};

/// Records one pass: its barriers, attachments and draws.
void record_pass(Pass pass, const PassContext& context);

}  // namespace sinew::viewer
