// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <tuple>
#include <vector>

#include "viewer/device/buffer.h"
#include "viewer/device/pipeline.h"
#include "viewer/passes/frame_targets.h"
#include "viewer/passes/frame_uniforms.h"
#include "viewer/upload/upload_mesh.h"

namespace sinew::viewer {

/// Layouts that all pipelines share: set 0 is the frame (shaders/frame_uniforms.glsl), set 1 the material
/// (shaders/material.glsl), and push constants hold a draw (shaders/geometry.glsl).
class PassLayouts {
 public:
  explicit PassLayouts(const Device& device);
  ~PassLayouts();
  PassLayouts(const PassLayouts&) = delete;
  PassLayouts& operator=(const PassLayouts&) = delete;

  VkPipelineLayout pipeline() const noexcept { return pipeline_; }
  VkDescriptorSetLayout frame() const noexcept { return frame_; }
  VkSampler nearest() const noexcept { return nearest_; }

 private:
  const Device& device_;
  VkSampler nearest_ = VK_NULL_HANDLE;
  VkDescriptorSetLayout frame_ = VK_NULL_HANDLE, material_ = VK_NULL_HANDLE;
  VkPipelineLayout pipeline_ = VK_NULL_HANDLE;
};

/// Uniforms and descriptor sets of one frame in flight.
class FrameSet {
 public:
  FrameSet(const Device& device, const PassLayouts& layouts);
  ~FrameSet();
  FrameSet(const FrameSet&) = delete;
  FrameSet& operator=(const FrameSet&) = delete;

  /// in   prepass  shaders read the depth image; false = it is only an attachment
  void write(const FrameUniforms& uniforms, const FrameTargets& targets, bool prepass);

  VkDescriptorSet set() const noexcept { return sets_[0]; }
  VkDescriptorSet between_blurs() const noexcept {
    return sets_[1];
  }  ///< its ao_image is the one after the first blur pass

 private:
  const Device& device_;
  VkSampler nearest_;
  Buffer uniforms_;
  VkDescriptorPool pool_ = VK_NULL_HANDLE;
  std::array<VkDescriptorSet, 2> sets_{};
};

/// How a pipeline for meshes differs from the others.
struct MeshPipelineKey {
  Pass pass = Pass::opaque;  ///< normal_depth, opaque or transparent
  Topology topology = Topology::triangles;
  bool masked = false;
  bool after_prepass = false;  ///< opaque: depth is there already, test for equal
  bool occluded = false;       ///< there is an ambient-access image
  bool depth_only = false;     ///< normal_depth: nobody reads normals

  auto operator<=>(const MeshPipelineKey&) const = default;
};

/// All pipelines. Each is created at its first use and kept.
class PassPipelines {
 public:
  PassPipelines(const Device& device, const PassLayouts& layouts, VkFormat target_format,
                const OcclusionShape& occlusion);
  ~PassPipelines();
  PassPipelines(const PassPipelines&) = delete;
  PassPipelines& operator=(const PassPipelines&) = delete;

  VkPipeline mesh(const MeshPipelineKey& key);
  VkPipeline screen(Pass pass, Show show = Show::color);  ///< of passes that cover the target; overlay = of the lines

 private:
  const Device& device_;
  const PassLayouts& layouts_;
  VkFormat target_format_;
  OcclusionShape occlusion_;
  std::map<MeshPipelineKey, VkPipeline> mesh_;
  std::map<std::pair<Pass, Show>, VkPipeline> screen_;
};

}  // namespace sinew::viewer
