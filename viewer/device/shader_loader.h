// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "viewer/device/device.h"

namespace sinew::viewer {

/// The shaders of viewer/shaders, compiled to SPIR-V at build time and embedded in the program. Variants named "rip"
/// read rip maps (viewer/shaders/texture_filter.glsl).
enum class Shader : std::uint8_t {
  geometry_vert,
  normal_depth_frag,
  normal_depth_rip_frag,
  cut_samples_frag,
  cut_samples_rip_frag,
  shade_frag,
  shade_rip_frag,
  gooch_frag,
  gooch_rip_frag,
  outline_frag,
  full_screen_vert,
  ssao_frag,
  gtao_frag,
  ssao_blur_frag,
  light_sums_frag,
  exposure_frag,
  tonemap_frag,
  show_frag,
  ground_vert,
  ground_normal_frag,
  ground_frag,
  line_vert,
  line_frag,
  backdrop_vert,
  backdrop_frag
};

std::span<const std::uint32_t> code_of(Shader shader) noexcept;

/// A shader module. It may be destroyed once the pipelines are created.
class ShaderModule {
 public:
  ShaderModule(const Device& device, Shader shader);
  ~ShaderModule() { vkDestroyShaderModule(device_, module_, nullptr); }
  ShaderModule(const ShaderModule&) = delete;
  ShaderModule& operator=(const ShaderModule&) = delete;

  VkPipelineShaderStageCreateInfo stage(VkShaderStageFlagBits stage,
                                        const VkSpecializationInfo* constants = nullptr) const noexcept;

 private:
  VkDevice device_;
  VkShaderModule module_ = VK_NULL_HANDLE;
};

}  // namespace sinew::viewer
