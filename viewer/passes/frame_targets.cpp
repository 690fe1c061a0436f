// SPDX-License-Identifier: MIT
#include "viewer/passes/frame_targets.h"

#include <algorithm>
#include <bit>

#include "viewer/passes/shadow_view.h"

namespace sinew::viewer {

namespace {

/// Number of mip levels down to one texel.
std::uint32_t mip_levels(VkExtent2D extent) noexcept {
  return static_cast<std::uint32_t>(std::bit_width(std::max(extent.width, extent.height)));
}

ImageShape shape_of(Target target, VkExtent2D full, VkExtent2D visibility, const ShadowTiles& shadows) {
  constexpr VkImageUsageFlags color = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT;
  switch (target) {
    case Target::depth:
      return {kDepthFormat, full, 1, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT};
    case Target::shadow:
      return {kDepthFormat,
              {kShadowSize * shadows.columns, kShadowSize * shadows.rows},
              1,
              VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT};
    case Target::color_samples:
    case Target::unlit_samples:
    case Target::weighted_sums_samples:
    case Target::weighted_coverage_samples:
    case Target::weighted_unlit_samples:
      return {kColorFormat, full, 1, VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT, false, kSmoothSamples};
    case Target::depth_samples:
      return {kDepthFormat, full, 1, VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT, false, kSmoothSamples};
    case Target::light_sums: return {kExposureFormat, {kExposureBlocks, kExposureBlocks}, 1, color};
    case Target::exposure: return {kExposureFormat, {1, 1}, 1, color};
    case Target::normals: return {kNormalFormat, full, 1, color};
    case Target::color:
    case Target::unlit: return {kColorFormat, full, 1, color | VK_IMAGE_USAGE_TRANSFER_SRC_BIT};
    case Target::behind:
    case Target::behind_unlit:
      return {kColorFormat, full, mip_levels(full),
              VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT};
    case Target::weighted_sums:
    case Target::weighted_coverage:
    case Target::weighted_unlit: return {kColorFormat, full, 1, color};
    default: return {kAoFormat, visibility, 1, color};
  }
}

}  // namespace

FrameTargets::FrameTargets(const Device& device, std::uint32_t ao_step)
    : device_(device),
      step_(ao_step),
      nothing_(device, {kAoFormat, {1, 1}, 1, VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT}) {
  constexpr ImageUse cleared{VK_PIPELINE_STAGE_2_CLEAR_BIT, VK_ACCESS_2_TRANSFER_WRITE_BIT,
                             VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL};
  device.run_now([&](VkCommandBuffer commands) {
    barrier(commands, nothing_.handle(), VK_IMAGE_ASPECT_COLOR_BIT, {}, cleared);
    const VkClearColorValue zero{};
    const VkImageSubresourceRange all{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    vkCmdClearColorImage(commands, nothing_.handle(), cleared.layout, &zero, 1, &all);
    barrier(commands, nothing_.handle(), VK_IMAGE_ASPECT_COLOR_BIT, cleared, kReadInShader);
  });
}

void FrameTargets::fit(const FrameGraph& graph, VkExtent2D extent) {
  const bool resized = extent.width != extent_.width || extent.height != extent_.height;
  const bool weighted = graph.weighted_images, weighted_unlit = weighted && graph.unlit_image;
  const std::array<bool, kTargetCount> wanted = {graph.depth_image,
                                                 graph.normal_image,
                                                 graph.ao_image,
                                                 graph.half_blurred_ao,
                                                 graph.color_image,
                                                 graph.shadow_maps > 0,
                                                 graph.sampled,
                                                 graph.sampled,
                                                 graph.unlit_image,
                                                 graph.unlit_image && graph.sampled,
                                                 graph.exposure_image,
                                                 graph.exposure_image,
                                                 graph.behind_image,
                                                 graph.behind_image && graph.unlit_image,
                                                 weighted,
                                                 weighted,
                                                 weighted_unlit,
                                                 weighted && graph.sampled,
                                                 weighted && graph.sampled,
                                                 weighted_unlit && graph.sampled};
  const bool other_maps = graph.shadow_maps != shadow_maps_;
  bool changed = resized || other_maps;
  for (std::size_t i = 0; i < kTargetCount; ++i) changed = changed || wanted[i] != static_cast<bool>(slots_[i].image);
  if (!changed) return;
  device_.wait_idle();
  extent_ = extent;
  shadow_maps_ = graph.shadow_maps;
  for (std::size_t i = 0; i < kTargetCount; ++i) {
    const bool fits = !resized && !(other_maps && static_cast<Target>(i) == Target::shadow);
    if (wanted[i] && fits && slots_[i].image) continue;
    slots_[i] = {};
    if (wanted[i])
      slots_[i].image =
          GpuImage(device_, shape_of(static_cast<Target>(i), extent_, ao_extent(), ShadowTiles(shadow_maps_)));
  }
}

void FrameTargets::next_use(VkCommandBuffer commands, Target target, const ImageUse& use, bool keep) {
  Slot& used = slot(target);
  ImageUse before = used.last;
  if (!keep) before.layout = VK_IMAGE_LAYOUT_UNDEFINED;
  barrier(commands, used.image.handle(), aspect_of(used.image.shape().format), before, use);
  used.last = use;
}

void FrameTargets::copy_into_levels(VkCommandBuffer commands, Target from, Target to) {
  next_use(commands, from, kCopyFrom);
  next_use(commands, to, kCopyTo, false);
  const VkImage levels = slot(to).image.handle();
  VkOffset3D larger{static_cast<std::int32_t>(extent_.width), static_cast<std::int32_t>(extent_.height), 1},
      size = larger;
  for (std::uint32_t level = 0; level < slot(to).image.shape().mip_count; ++level) {
    VkImageBlit blit{};
    blit.srcSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, level > 0 ? level - 1 : 0, 0, 1};
    blit.srcOffsets[1] = larger;
    blit.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, level, 0, 1};
    blit.dstOffsets[1] = size;
    vkCmdBlitImage(commands, level > 0 ? levels : slot(from).image.handle(), kCopyFrom.layout, levels, kCopyTo.layout,
                   1, &blit, VK_FILTER_LINEAR);
    barrier(commands, levels, VK_IMAGE_ASPECT_COLOR_BIT, kCopyTo, kCopyFrom, {level, 1});
    larger = size;
    size = {std::max(size.x / 2, 1), std::max(size.y / 2, 1), 1};
  }
  slot(to).last = kCopyFrom;
}

}  // namespace sinew::viewer
