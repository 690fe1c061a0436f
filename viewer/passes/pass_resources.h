// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <map>
#include <vector>

#include "viewer/device/buffer.h"
#include "viewer/device/pipeline.h"
#include "viewer/passes/draw_list.h"
#include "viewer/passes/frame_targets.h"
#include "viewer/passes/frame_uniforms.h"
#include "viewer/passes/pipeline_keys.h"
#include "viewer/upload/environment_upload.h"
#include "viewer/upload/upload_mesh.h"

namespace sinew::viewer {

/// Layouts shared by all pipelines. Set 0 is for the frame (shaders/frame_uniforms.glsl), set 1 for the material
/// (shaders/material.glsl), push constants for a draw (shaders/geometry.glsl).
class PassLayouts {
 public:
  explicit PassLayouts(const Device& device);
  ~PassLayouts();
  PassLayouts(const PassLayouts&) = delete;
  PassLayouts& operator=(const PassLayouts&) = delete;

  VkPipelineLayout pipeline() const noexcept { return pipeline_; }
  VkDescriptorSetLayout frame() const noexcept { return frame_; }
  VkSampler nearest() const noexcept { return nearest_; }
  VkSampler linear() const noexcept { return linear_; }

 private:
  const Device& device_;
  VkSampler nearest_ = VK_NULL_HANDLE, linear_ = VK_NULL_HANDLE;
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

  /// in   prepass  true = shaders read the depth image; false = it is only an attachment
  ///      environment  its images must outlive the frame
  void write(const FrameUniforms& uniforms, const FrameTargets& targets, const EnvironmentUpload& environment,
             bool prepass);

  VkDescriptorSet set() const noexcept { return sets_[0]; }
  /// Variant whose ao_image is the result of the first blur pass.
  VkDescriptorSet between_blurs() const noexcept { return sets_[1]; }
  /// Variant whose exposure_image holds the block sums.
  VkDescriptorSet before_exposure() const noexcept { return sets_[1]; }
  /// Variant with behind_image and behind_unlit_image; in the others they are a black texel.
  VkDescriptorSet with_behind() const noexcept { return sets_[2]; }
  /// Variant without shadow_image, for the pass that draws the shadow maps.
  VkDescriptorSet without_shadow() const noexcept { return sets_[1]; }

 private:
  const Device& device_;
  VkSampler nearest_, linear_;
  Buffer uniforms_;
  VkDescriptorPool pool_ = VK_NULL_HANDLE;
  std::array<VkDescriptorSet, 3> sets_{};
};

/// All pipelines; each is created at its first use and kept.
class PassPipelines {
 public:
  PassPipelines(const Device& device, const PassLayouts& layouts, VkFormat target_format,
                const OcclusionShape& occlusion);
  ~PassPipelines();
  PassPipelines(const PassPipelines&) = delete;
  PassPipelines& operator=(const PassPipelines&) = delete;

  /// True if shaders encode what is displayed to sRGB; false if the hardware does.
  bool encodes() const noexcept;

  VkPipeline mesh(const MeshPipelineKey& key);
  VkPipeline screen(const ScreenPipelineKey& key);

 private:
  const Device& device_;
  const PassLayouts& layouts_;
  VkFormat target_format_;
  OcclusionShape occlusion_;
  std::map<MeshPipelineKey, VkPipeline> mesh_;
  std::map<ScreenPipelineKey, VkPipeline> screen_;
};

}  // namespace sinew::viewer
