// SPDX-License-Identifier: MIT
#include "viewer/device/shader_loader.h"

namespace sinew::viewer {

namespace {

constexpr std::uint32_t kGeometryVert[] =
#include "geometry.vert.inc"
    ;
constexpr std::uint32_t kNormalDepthFrag[] =
#include "normal_depth.frag.inc"
    ;
constexpr std::uint32_t kNormalDepthRipFrag[] =
#include "normal_depth_rip.frag.inc"
    ;
constexpr std::uint32_t kCutSamplesFrag[] =
#include "cut_samples.frag.inc"
    ;
constexpr std::uint32_t kCutSamplesRipFrag[] =
#include "cut_samples_rip.frag.inc"
    ;
constexpr std::uint32_t kShadeFrag[] =
#include "shade.frag.inc"
    ;
constexpr std::uint32_t kShadeRipFrag[] =
#include "shade_rip.frag.inc"
    ;
constexpr std::uint32_t kGoochFrag[] =
#include "gooch.frag.inc"
    ;
constexpr std::uint32_t kGoochRipFrag[] =
#include "gooch_rip.frag.inc"
    ;
constexpr std::uint32_t kOutlineFrag[] =
#include "outline.frag.inc"
    ;
constexpr std::uint32_t kFullScreenVert[] =
#include "full_screen.vert.inc"
    ;
constexpr std::uint32_t kSsaoFrag[] =
#include "ssao.frag.inc"
    ;
constexpr std::uint32_t kGtaoFrag[] =
#include "gtao.frag.inc"
    ;
constexpr std::uint32_t kSsaoBlurFrag[] =
#include "ssao_blur.frag.inc"
    ;
constexpr std::uint32_t kLightSumsFrag[] =
#include "light_sums.frag.inc"
    ;
constexpr std::uint32_t kExposureFrag[] =
#include "exposure.frag.inc"
    ;
constexpr std::uint32_t kTonemapFrag[] =
#include "tonemap.frag.inc"
    ;
constexpr std::uint32_t kShowFrag[] =
#include "show.frag.inc"
    ;
constexpr std::uint32_t kGroundVert[] =
#include "ground.vert.inc"
    ;
constexpr std::uint32_t kGroundNormalFrag[] =
#include "ground_normal.frag.inc"
    ;
constexpr std::uint32_t kGroundFrag[] =
#include "ground.frag.inc"
    ;
constexpr std::uint32_t kLineVert[] =
#include "line.vert.inc"
    ;
constexpr std::uint32_t kBackdropVert[] =
#include "backdrop.vert.inc"
    ;
constexpr std::uint32_t kBackdropFrag[] =
#include "backdrop.frag.inc"
    ;
constexpr std::uint32_t kLineFrag[] =
#include "line.frag.inc"
    ;

}  // namespace

std::span<const std::uint32_t> code_of(Shader shader) noexcept {
  switch (shader) {
    case Shader::geometry_vert: return kGeometryVert;
    case Shader::normal_depth_frag: return kNormalDepthFrag;
    case Shader::normal_depth_rip_frag: return kNormalDepthRipFrag;
    case Shader::cut_samples_frag: return kCutSamplesFrag;
    case Shader::cut_samples_rip_frag: return kCutSamplesRipFrag;
    case Shader::shade_frag: return kShadeFrag;
    case Shader::shade_rip_frag: return kShadeRipFrag;
    case Shader::gooch_frag: return kGoochFrag;
    case Shader::gooch_rip_frag: return kGoochRipFrag;
    case Shader::outline_frag: return kOutlineFrag;
    case Shader::full_screen_vert: return kFullScreenVert;
    case Shader::ssao_frag: return kSsaoFrag;
    case Shader::gtao_frag: return kGtaoFrag;
    case Shader::ssao_blur_frag: return kSsaoBlurFrag;
    case Shader::light_sums_frag: return kLightSumsFrag;
    case Shader::exposure_frag: return kExposureFrag;
    case Shader::tonemap_frag: return kTonemapFrag;
    case Shader::show_frag: return kShowFrag;
    case Shader::ground_vert: return kGroundVert;
    case Shader::ground_normal_frag: return kGroundNormalFrag;
    case Shader::ground_frag: return kGroundFrag;
    case Shader::backdrop_vert: return kBackdropVert;
    case Shader::backdrop_frag: return kBackdropFrag;
    case Shader::line_vert: return kLineVert;
    default: return kLineFrag;
  }
}

ShaderModule::ShaderModule(const Device& device, Shader shader) : device_(device.handle()) {
  const std::span<const std::uint32_t> code = code_of(shader);
  VkShaderModuleCreateInfo info{VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
  info.codeSize = code.size_bytes();
  info.pCode = code.data();
  must(vkCreateShaderModule(device_, &info, nullptr, &module_), "vkCreateShaderModule");
}

VkPipelineShaderStageCreateInfo ShaderModule::stage(VkShaderStageFlagBits stage,
                                                    const VkSpecializationInfo* constants) const noexcept {
  VkPipelineShaderStageCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO};
  info.stage = stage;
  info.module = module_;
  info.pName = "main";
  info.pSpecializationInfo = constants;
  return info;
}

}  // namespace sinew::viewer
