// SPDX-License-Identifier: MIT
#include "viewer/device/image.h"

#include <utility>

namespace sinew::viewer {

VkImageAspectFlags aspect_of(VkFormat format) noexcept {
  return format == VK_FORMAT_D32_SFLOAT ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
}

// Delegates to the default constructor, so that the destructor runs if the body throws.
GpuImage::GpuImage(const Device& device, const ImageShape& shape) : GpuImage() {
  device_ = &device;
  shape_ = shape;
  VkImageCreateInfo info{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
  info.imageType = VK_IMAGE_TYPE_2D;
  info.format = shape.format;
  info.extent = {shape.extent.width, shape.extent.height, 1};
  info.mipLevels = shape.mip_count;
  info.arrayLayers = shape.layers();
  info.flags = shape.cube ? VkImageCreateFlags{VK_IMAGE_CREATE_CUBE_COMPATIBLE_BIT} : 0;
  info.samples = static_cast<VkSampleCountFlagBits>(shape.samples);
  info.tiling = VK_IMAGE_TILING_OPTIMAL;
  info.usage = shape.usage;
  must(vkCreateImage(device.handle(), &info, nullptr, &image_), "vkCreateImage");
  VkMemoryRequirements needs{};
  vkGetImageMemoryRequirements(device.handle(), image_, &needs);
  piece_ = device.memory().allocate(needs, MemoryUse::device, true);
  must(vkBindImageMemory(device.handle(), image_, piece_.memory, piece_.offset), "vkBindImageMemory");
  VkImageViewCreateInfo view{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
  view.image = image_;
  view.viewType = shape.cube ? VK_IMAGE_VIEW_TYPE_CUBE : VK_IMAGE_VIEW_TYPE_2D;
  view.format = shape.format;
  view.subresourceRange = {aspect_of(shape.format), 0, shape.mip_count, 0, shape.layers()};
  must(vkCreateImageView(device.handle(), &view, nullptr, &view_), "vkCreateImageView");
}

GpuImage::GpuImage(GpuImage&& other) noexcept { *this = std::move(other); }

GpuImage& GpuImage::operator=(GpuImage&& other) noexcept {
  if (this == &other) return *this;
  reset();
  device_ = other.device_;
  image_ = std::exchange(other.image_, VK_NULL_HANDLE);
  view_ = std::exchange(other.view_, VK_NULL_HANDLE);
  shape_ = other.shape_;
  piece_ = std::exchange(other.piece_, {});
  return *this;
}

void GpuImage::reset() noexcept {
  if (!image_) return;
  vkDestroyImageView(device_->handle(), view_, nullptr);
  vkDestroyImage(device_->handle(), image_, nullptr);
  if (piece_.memory) device_->memory().free(piece_);
  image_ = VK_NULL_HANDLE;
}

void barrier(VkCommandBuffer commands, VkImage image, VkImageAspectFlags aspect, const ImageUse& before,
             const ImageUse& after, const MipRange& levels) {
  VkImageMemoryBarrier2 change{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER_2};
  change.srcStageMask = before.stage;
  change.srcAccessMask = before.access;
  change.dstStageMask = after.stage;
  change.dstAccessMask = after.access;
  change.oldLayout = before.layout;
  change.newLayout = after.layout;
  change.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  change.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  change.image = image;
  change.subresourceRange = {aspect, levels.first, levels.count, 0, VK_REMAINING_ARRAY_LAYERS};
  VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
  dependency.imageMemoryBarrierCount = 1;
  dependency.pImageMemoryBarriers = &change;
  vkCmdPipelineBarrier2(commands, &dependency);
}

void read_back(VkCommandBuffer commands, VkImage image, VkExtent2D extent, VkBuffer to) {
  VkBufferImageCopy region{};
  region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
  region.imageExtent = {extent.width, extent.height, 1};
  vkCmdCopyImageToBuffer(commands, image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, to, 1, &region);
  VkMemoryBarrier2 to_host{VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
  to_host.srcStageMask = VK_PIPELINE_STAGE_2_COPY_BIT;
  to_host.srcAccessMask = VK_ACCESS_2_TRANSFER_WRITE_BIT;
  to_host.dstStageMask = VK_PIPELINE_STAGE_2_HOST_BIT;
  to_host.dstAccessMask = VK_ACCESS_2_HOST_READ_BIT;
  VkDependencyInfo dependency{VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
  dependency.memoryBarrierCount = 1;
  dependency.pMemoryBarriers = &to_host;
  vkCmdPipelineBarrier2(commands, &dependency);
}

}  // namespace sinew::viewer
