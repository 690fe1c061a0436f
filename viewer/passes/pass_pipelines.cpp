// SPDX-License-Identifier: MIT
#include "viewer/passes/pass_resources.h"

namespace sinew::viewer {

namespace {

constexpr std::array<VkFormat, kAttributeCount> kAttributeFormats = {
    VK_FORMAT_R32G32B32_SFLOAT, VK_FORMAT_R32G32B32_SFLOAT, VK_FORMAT_R32G32B32A32_SFLOAT,
    VK_FORMAT_R32G32_SFLOAT,    VK_FORMAT_R32G32_SFLOAT,    VK_FORMAT_R32G32B32A32_SFLOAT};

VkPrimitiveTopology vulkan(Topology topology) noexcept {
  switch (topology) {
    case Topology::points: return VK_PRIMITIVE_TOPOLOGY_POINT_LIST;
    case Topology::lines: return VK_PRIMITIVE_TOPOLOGY_LINE_LIST;
    default: return VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  }
}

bool encodes_in_hardware(VkFormat format) noexcept {
  return format == VK_FORMAT_B8G8R8A8_SRGB || format == VK_FORMAT_R8G8B8A8_SRGB ||
         format == VK_FORMAT_A8B8G8R8_SRGB_PACK32;
}

}  // namespace

PassPipelines::PassPipelines(const Device& device, const PassLayouts& layouts, VkFormat target_format,
                             const OcclusionShape& occlusion)
    : device_(device), layouts_(layouts), target_format_(target_format), occlusion_(occlusion) {}

PassPipelines::~PassPipelines() {
  for (const auto& [key, pipeline] : mesh_) vkDestroyPipeline(device_.handle(), pipeline, nullptr);
  for (const auto& [key, pipeline] : screen_) vkDestroyPipeline(device_.handle(), pipeline, nullptr);
}

VkPipeline PassPipelines::mesh(const MeshPipelineKey& key) {
  VkPipeline& pipeline = mesh_[key];
  if (pipeline) return pipeline;
  std::array<VkVertexInputBindingDescription, kAttributeCount> bindings{};
  std::array<VkVertexInputAttributeDescription, kAttributeCount> attributes{};
  for (std::uint32_t a = 0; a < kAttributeCount; ++a) {
    bindings[a] = {a, kAttributeBytes[a], VK_VERTEX_INPUT_RATE_VERTEX};
    attributes[a] = {a, a, kAttributeFormats[a], 0};
  }
  PipelineShape shape;
  shape.vertex = Shader::geometry_vert;
  shape.topology = vulkan(key.topology);
  shape.depth = true;
  shape.meshes = true;
  shape.bindings = bindings;
  shape.attributes = attributes;
  const bool prepass = key.pass == Pass::normal_depth, blended = key.pass == Pass::transparent;
  shape.fragment = prepass ? Shader::normal_depth_frag : Shader::shade_frag;
  shape.color_format = key.depth_only ? VK_FORMAT_UNDEFINED : prepass ? kNormalFormat : kColorFormat;
  shape.constants = {key.masked, blended, key.occluded, occlusion_.step};
  shape.depth_write = prepass || (!blended && !key.after_prepass);
  shape.depth_compare = !blended && key.after_prepass ? VK_COMPARE_OP_EQUAL : VK_COMPARE_OP_GREATER_OR_EQUAL;
  shape.blend = blended;
  return pipeline = make_pipeline(device_, layouts_.pipeline(), shape);
}

VkPipeline PassPipelines::screen(Pass pass, Show show) {
  VkPipeline& pipeline = screen_[{pass, show}];
  if (pipeline) return pipeline;
  PipelineShape shape;
  shape.color_format = target_format_;
  shape.constants = {!encodes_in_hardware(target_format_), static_cast<std::uint32_t>(show), 0, occlusion_.step};
  constexpr std::array<VkVertexInputBindingDescription, 1> line_bindings = {{{0, 16, VK_VERTEX_INPUT_RATE_VERTEX}}};
  constexpr std::array<VkVertexInputAttributeDescription, 2> line_attributes = {
      {{0, 0, VK_FORMAT_R32G32B32_SFLOAT, 0}, {1, 0, VK_FORMAT_R8G8B8A8_UNORM, 12}}};
  switch (pass) {
    case Pass::ssao:
      shape.fragment = Shader::ssao_frag;
      shape.color_format = kAoFormat;
      shape.constants = {occlusion_.samples, 0, 0, occlusion_.step};
      break;
    case Pass::blur_horizontal:
    case Pass::blur_vertical:
      shape.fragment = Shader::ssao_blur_frag;
      shape.color_format = kAoFormat;
      shape.constants = {pass == Pass::blur_vertical, occlusion_.blur_reach, occlusion_.keep_edges, occlusion_.step};
      break;
    case Pass::show: shape.fragment = Shader::show_frag; break;
    case Pass::overlay:
      shape.vertex = Shader::line_vert;
      shape.fragment = Shader::line_frag;
      shape.topology = VK_PRIMITIVE_TOPOLOGY_LINE_LIST;
      shape.bindings = line_bindings;
      shape.attributes = line_attributes;
      shape.blend = true;
      shape.premultiplied = false;
      break;
    default: shape.fragment = Shader::tonemap_frag; break;
  }
  return pipeline = make_pipeline(device_, layouts_.pipeline(), shape);
}

}  // namespace sinew::viewer
