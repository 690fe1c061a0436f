// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <span>
#include <vector>

#include "viewer/device/shader_loader.h"

namespace sinew::viewer {

inline constexpr std::size_t kShaderConstants = 40;
inline constexpr std::size_t kMostColors = 3;  ///< attachments of a pass

/// What becomes of a drawn colour s over the stored one d. The second attachment of a frame stores light that is shown
/// as it is, and its share of the coverage.
enum class Blending : std::uint8_t {
  over,       ///< s + d (1 - s.a): premultiplied
  straight,   ///< s s.a + d (1 - s.a)
  filter,     ///< d s, coverage s.a + d.a (1 - s.a);   second: d s, share d.a (1 - s.a)
  uncovered,  ///< d + s (1 - d.a), coverage too: behind what is drawn; shaders give the second no colour
  add,        ///< d + s; the same
  erase,      ///< d (1 - s.a), coverage too; the same
  weighted    ///< sums, d + s;   second: coverage, s + d (1 - s);   third: sums, too
};

/// What differs between the graphics pipelines. The rest is fixed: dynamic rendering, dynamic viewport and scissor, up
/// to three colour attachments of one format, reversed depth.
struct PipelineShape {
  Shader vertex = Shader::full_screen_vert, fragment = Shader::tonemap_frag;
  std::array<std::uint32_t, kShaderConstants> constants{};  ///< specialisation constants of both shaders, by their ids
  VkPrimitiveTopology topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  VkFormat color_format = VK_FORMAT_UNDEFINED;
  std::uint32_t colors = 1;   ///< attachments, where there is a format; what blends over the second covers it, but adds
                              ///< no coverage
  bool adds_second = false;   ///< what blends adds its own coverage to the second attachment
  std::uint32_t samples = 1;  ///< of the attachments: 1 or 4
  bool depth = false;         ///< there is a D32 depth attachment
  bool depth_write = false;
  VkCompareOp depth_compare = VK_COMPARE_OP_ALWAYS;
  bool blend = false;
  Blending blending = Blending::over;
  bool meshes = false;  ///< cull mode, front face and vertex strides are dynamic
  std::span<const VkVertexInputBindingDescription> bindings;
  std::span<const VkVertexInputAttributeDescription> attributes;
};

/// Creates a pipeline; the caller destroys it.   err  DeviceError
VkPipeline make_pipeline(const Device& device, VkPipelineLayout layout, const PipelineShape& shape);

}  // namespace sinew::viewer
