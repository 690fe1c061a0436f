// SPDX-License-Identifier: MIT
#include "viewer/device/pipeline.h"

#include <gmock/gmock.h>

#include "tests/viewer/own_driver.h"

namespace sinew::viewer {
namespace {

using testing::Each;
using testing::ElementsAre;

/// Copies of a pipeline's create info, whose pointers are only valid during the call.
struct Asked {
  std::vector<VkPipelineColorBlendAttachmentState> blends;
  std::vector<VkFormat> formats;
  std::vector<VkDynamicState> dynamic;
  std::vector<std::vector<std::uint32_t>> constants;  ///< [stages][constant_id]
  std::vector<VkShaderStageFlagBits> stages;
  VkPipelineDepthStencilStateCreateInfo depth{};
  VkFormat depth_format = VK_FORMAT_UNDEFINED;
  VkPipelineRasterizationStateCreateInfo raster{};
  VkSampleCountFlagBits samples{};
  VkPrimitiveTopology topology{};
  std::uint32_t viewports = 0, scissors = 0;
  std::vector<std::uint32_t> bindings, attributes;  ///< strides of bindings, offsets of attributes
};

std::vector<std::uint32_t> constants_of(const VkSpecializationInfo& info) {
  std::vector<std::uint32_t> values(info.mapEntryCount, ~0u);
  for (std::uint32_t i = 0; i < info.mapEntryCount; ++i) {
    const VkSpecializationMapEntry& entry = info.pMapEntries[i];
    EXPECT_EQ(entry.size, 4u);
    EXPECT_LE(entry.offset + entry.size, info.dataSize);
    values.at(entry.constantID) = static_cast<const std::uint32_t*>(info.pData)[entry.offset / 4];
  }
  return values;
}

class pipeline : public OwnDriverTest {
 protected:
  static Asked asked(const PipelineShape& shape) {
    const Device device;
    const auto layout = reinterpret_cast<VkPipelineLayout>(std::size_t{7});
    Asked out;
    own_driver().on_pipeline = [&](const VkGraphicsPipelineCreateInfo& info) {
      const auto& blend = *info.pColorBlendState;
      out.blends.assign(blend.pAttachments, blend.pAttachments + blend.attachmentCount);
      const auto& rendering = *static_cast<const VkPipelineRenderingCreateInfo*>(info.pNext);
      out.formats.assign(rendering.pColorAttachmentFormats,
                         rendering.pColorAttachmentFormats + rendering.colorAttachmentCount);
      out.depth_format = rendering.depthAttachmentFormat;
      out.dynamic.assign(info.pDynamicState->pDynamicStates,
                         info.pDynamicState->pDynamicStates + info.pDynamicState->dynamicStateCount);
      for (std::uint32_t i = 0; i < info.stageCount; ++i) {
        out.stages.push_back(info.pStages[i].stage);
        out.constants.push_back(constants_of(*info.pStages[i].pSpecializationInfo));
      }
      out.depth = *info.pDepthStencilState;
      out.raster = *info.pRasterizationState;
      out.samples = info.pMultisampleState->rasterizationSamples;
      out.topology = info.pInputAssemblyState->topology;
      out.viewports = info.pViewportState->viewportCount;
      out.scissors = info.pViewportState->scissorCount;
      const VkPipelineVertexInputStateCreateInfo& input = *info.pVertexInputState;
      for (std::uint32_t i = 0; i < input.vertexBindingDescriptionCount; ++i)
        out.bindings.push_back(input.pVertexBindingDescriptions[i].stride);
      for (std::uint32_t i = 0; i < input.vertexAttributeDescriptionCount; ++i)
        out.attributes.push_back(input.pVertexAttributeDescriptions[i].offset);
      EXPECT_EQ(info.layout, layout);
    };
    make_pipeline(device, layout, shape);
    return out;
  }
};

struct Texel {
  double color, alpha;
};
constexpr Texel kDrawn{0.3, 0.7}, kStored{0.6, 0.2};

/// The numeric value of a blend factor.
double value_of(VkBlendFactor factor, double own) {
  switch (factor) {
    case VK_BLEND_FACTOR_ZERO: return 0.0;
    case VK_BLEND_FACTOR_ONE: return 1.0;
    case VK_BLEND_FACTOR_SRC_COLOR: return own;
    case VK_BLEND_FACTOR_SRC_ALPHA: return kDrawn.alpha;
    case VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA: return 1.0 - kDrawn.alpha;
    case VK_BLEND_FACTOR_ONE_MINUS_DST_ALPHA: return 1.0 - kStored.alpha;
    default: ADD_FAILURE() << factor; return -1.0;
  }
}

Texel blended(const VkPipelineColorBlendAttachmentState& blend) {
  EXPECT_TRUE(blend.blendEnable);
  EXPECT_EQ(blend.colorBlendOp, VK_BLEND_OP_ADD);
  EXPECT_EQ(blend.alphaBlendOp, VK_BLEND_OP_ADD);
  return {kDrawn.color * value_of(blend.srcColorBlendFactor, kDrawn.color) +
              kStored.color * value_of(blend.dstColorBlendFactor, kDrawn.color),
          kDrawn.alpha * value_of(blend.srcAlphaBlendFactor, kDrawn.alpha) +
              kStored.alpha * value_of(blend.dstAlphaBlendFactor, kDrawn.alpha)};
}

TEST_F(pipeline, blends_by_the_formula_of_each_kind) {
  const Texel s = kDrawn, d = kStored;
  const double rest = 1.0 - s.alpha, over = s.alpha + d.alpha * rest;
  struct Case {
    Blending blending;
    Texel first, second;
  };
  for (const Case& c :
       {Case{Blending::over, {s.color + d.color * rest, over}, {s.color + d.color * rest, d.alpha * rest}},
        {Blending::straight,
         {s.color * s.alpha + d.color * rest, over},
         {s.color * s.alpha + d.color * rest, d.alpha * rest}},
        {Blending::filter, {d.color * s.color, over}, {d.color * s.color, d.alpha * rest}},
        {Blending::uncovered,
         {d.color + s.color * (1.0 - d.alpha), d.alpha + s.alpha * (1.0 - d.alpha)},
         {d.color + s.color * (1.0 - d.alpha), d.alpha}},
        {Blending::add, {d.color + s.color, d.alpha + s.alpha}, {d.color + s.color, d.alpha}},
        {Blending::erase, {d.color * rest, d.alpha * rest}, {d.color * rest, d.alpha * rest}},
        {Blending::weighted, {d.color + s.color, d.alpha + s.alpha}, {s.color + d.color * rest, over}}}) {
    for (const bool adds : {false, true}) {
      const Asked a = asked({.color_format = VK_FORMAT_R8G8B8A8_UNORM,
                             .colors = 3,
                             .adds_second = adds,
                             .blend = true,
                             .blending = c.blending});
      ASSERT_EQ(a.blends.size(), 3u);
      const Texel second = adds && c.blending != Blending::weighted ? c.first : c.second;
      const Texel expected[] = {c.first, second, c.first};
      for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(blended(a.blends[i]).color, expected[i].color, 1e-12) << int(c.blending) << ' ' << i;
        EXPECT_NEAR(blended(a.blends[i]).alpha, expected[i].alpha, 1e-12) << int(c.blending) << ' ' << i << adds;
        EXPECT_EQ(a.blends[i].colorWriteMask, 15u);
      }
    }
  }
  EXPECT_FALSE(asked({.color_format = VK_FORMAT_R8G8B8A8_UNORM}).blends.at(0).blendEnable);
}

TEST_F(pipeline, has_the_attachments_that_are_asked_for) {
  EXPECT_THAT(asked({}).formats, testing::IsEmpty());
  EXPECT_THAT(asked({.colors = 2}).blends, testing::IsEmpty()) << "without a format";
  EXPECT_THAT(asked({.color_format = VK_FORMAT_R16G16B16A16_SFLOAT, .colors = 3}).formats,
              ElementsAre(VK_FORMAT_R16G16B16A16_SFLOAT, VK_FORMAT_R16G16B16A16_SFLOAT, VK_FORMAT_R16G16B16A16_SFLOAT));
  EXPECT_EQ(asked({}).depth_format, VK_FORMAT_UNDEFINED);
  EXPECT_FALSE(asked({}).depth.depthTestEnable);
  const Asked deep = asked({.samples = 4, .depth = true, .depth_compare = VK_COMPARE_OP_GREATER});
  EXPECT_EQ(deep.depth_format, VK_FORMAT_D32_SFLOAT);
  EXPECT_TRUE(deep.depth.depthTestEnable);
  EXPECT_FALSE(deep.depth.depthWriteEnable);
  EXPECT_EQ(deep.depth.depthCompareOp, VK_COMPARE_OP_GREATER);
  EXPECT_EQ(deep.samples, VK_SAMPLE_COUNT_4_BIT);
  EXPECT_EQ(asked({}).samples, VK_SAMPLE_COUNT_1_BIT);
  EXPECT_TRUE(asked({.depth = true, .depth_write = true}).depth.depthWriteEnable);
}

TEST_F(pipeline, of_meshes_alone_is_told_of_faces_and_strides_while_it_draws) {
  EXPECT_THAT(asked({}).dynamic, ElementsAre(VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR));
  EXPECT_THAT(asked({.meshes = true}).dynamic,
              ElementsAre(VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR, VK_DYNAMIC_STATE_CULL_MODE,
                          VK_DYNAMIC_STATE_FRONT_FACE, VK_DYNAMIC_STATE_VERTEX_INPUT_BINDING_STRIDE));
  const std::vector<VkVertexInputBindingDescription> bindings = {{0, 12, {}}, {1, 8, {}}};
  const std::vector<VkVertexInputAttributeDescription> attributes = {{0, 0, {}, 1}, {1, 0, {}, 2}, {2, 1, {}, 3}};
  const Asked a = asked({.topology = VK_PRIMITIVE_TOPOLOGY_LINE_LIST, .bindings = bindings, .attributes = attributes});
  EXPECT_EQ(a.topology, VK_PRIMITIVE_TOPOLOGY_LINE_LIST);
  EXPECT_THAT(a.bindings, ElementsAre(12, 8));
  EXPECT_THAT(a.attributes, ElementsAre(1, 2, 3));
  EXPECT_EQ(a.viewports, 1u);
  EXPECT_EQ(a.scissors, 1u);
  EXPECT_EQ(a.raster.polygonMode, VK_POLYGON_MODE_FILL);
  EXPECT_EQ(a.raster.cullMode, VkCullModeFlags{VK_CULL_MODE_NONE});
  EXPECT_EQ(a.raster.lineWidth, 1.0f);
}

TEST_F(pipeline, gives_both_shaders_every_constant) {
  PipelineShape shape;
  for (std::uint32_t i = 0; i < kShaderConstants; ++i) shape.constants[i] = 100 + i;
  const Asked a = asked(shape);
  EXPECT_THAT(a.stages, ElementsAre(VK_SHADER_STAGE_VERTEX_BIT, VK_SHADER_STAGE_FRAGMENT_BIT));
  EXPECT_THAT(a.constants, Each(testing::ElementsAreArray(shape.constants)));
}

}  // namespace
}  // namespace sinew::viewer
