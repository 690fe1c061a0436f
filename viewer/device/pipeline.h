// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <span>
#include <vector>

#include "viewer/device/shader_loader.h"

namespace sinew::viewer {

inline constexpr std::size_t kShaderConstants = 52;
inline constexpr std::size_t kMostColors = 3;  ///< color attachments of a pass

/// How a source colour s is combined with the stored colour d. Notes after "second" and "third" apply to those
/// attachments. The second attachment of a frame holds light that is shown without tone mapping, and its share of
/// coverage.
enum class Blending : std::uint8_t {
  over,      ///< s + d (1 - s.a); s has premultiplied alpha
  straight,  ///< s s.a + d (1 - s.a)
  filter,    ///< d s, coverage s.a + d.a (1 - s.a);   second: d s, share d.a (1 - s.a)
  /// D + s (1 - d.a), also for coverage: draws behind the stored picture; shaders write no colour to the second.
  uncovered,
  add,      ///< d + s;   second: likewise
  erase,    ///< d (1 - s.a), also for coverage;   second: likewise
  weighted  ///< d + s, a sum of weighted colours;   second: coverage, s + d (1 - s);   third: d + s
};

/// Parameters that differ between the graphics pipelines. Fixed for all: dynamic rendering, dynamic viewport and
/// scissor, one colour format, reversed depth.
struct PipelineShape {
  Shader vertex = Shader::full_screen_vert, fragment = Shader::tonemap_frag;
  /// Specialisation constants of both shaders, indexed by constant_id.
  std::array<std::uint32_t, kShaderConstants> constants{};
  VkPrimitiveTopology topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  VkFormat color_format = VK_FORMAT_UNDEFINED;
  /// Number of colour attachments if color_format is set; blended draws cover the second one but add no coverage to it.
  std::uint32_t colors = 1;
  bool adds_second = false;   ///< blended draws also add their coverage to the second attachment
  std::uint32_t samples = 1;  ///< samples per texel of the attachments: 1 or 4
  bool depth = false;         ///< true = uses a D32 depth attachment
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
