// SPDX-License-Identifier: MIT
#pragma once
#include "viewer/passes/draw_list.h"
#include "viewer/passes/frame_renderer.h"
#include "viewer/passes/pass_resources.h"

namespace sinew::viewer {

/// What recording a pass needs. The images between passes exist already and have the size of the target.
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
  VkRect2D occluded;  ///< texels of ambient occlusion with a surface
  VkBuffer lines;     ///< vertices in view space, 16 bytes each
  std::uint32_t line_vertices;
};

/// Records one pass: the barriers in front of it, its attachments and its draws.
void record_pass(Pass pass, const PassContext& context);

}  // namespace sinew::viewer
