// SPDX-License-Identifier: MIT
#pragma once
#include "viewer/device/device.h"

namespace sinew::viewer {

struct ImageShape {
  VkFormat format = VK_FORMAT_UNDEFINED;
  VkExtent2D extent{1, 1};
  std::uint32_t mip_count = 1;
  VkImageUsageFlags usage = 0;
};

/// A 2D image, a view of all of it and its memory; movable, destroyed with its device still alive.
class GpuImage {
 public:
  GpuImage() = default;
  GpuImage(const Device& device, const ImageShape& shape);
  ~GpuImage() { reset(); }
  GpuImage(GpuImage&& other) noexcept;
  GpuImage& operator=(GpuImage&& other) noexcept;

  VkImage handle() const noexcept { return image_; }
  VkImageView view() const noexcept { return view_; }
  const ImageShape& shape() const noexcept { return shape_; }
  explicit operator bool() const noexcept { return image_ != VK_NULL_HANDLE; }

 private:
  void reset() noexcept;

  const Device* device_ = nullptr;
  VkImage image_ = VK_NULL_HANDLE;
  VkImageView view_ = VK_NULL_HANDLE;
  ImageShape shape_;
  MemoryPiece piece_;
};

/// What an image was used for before a barrier, or will be after it.
struct ImageUse {
  VkPipelineStageFlags2 stage = VK_PIPELINE_STAGE_2_NONE;
  VkAccessFlags2 access = VK_ACCESS_2_NONE;
  VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
};

/// Makes writes of `before` visible to `after` and changes the layout; layout UNDEFINED in `before` drops the contents.
void barrier(VkCommandBuffer commands, VkImage image, VkImageAspectFlags aspect, const ImageUse& before,
             const ImageUse& after);

VkImageAspectFlags aspect_of(VkFormat format) noexcept;

}  // namespace sinew::viewer
