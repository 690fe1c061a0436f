// SPDX-License-Identifier: MIT
#pragma once
#include "viewer/device/device.h"

namespace sinew::viewer {

struct ImageShape {
  VkFormat format = VK_FORMAT_UNDEFINED;
  VkExtent2D extent{1, 1};
  std::uint32_t mip_count = 1;
  VkImageUsageFlags usage = 0;
  bool cube = false;          ///< six faces, viewed as a cube
  std::uint32_t samples = 1;  ///< samples per texel: 1 or 4

  std::uint32_t layers() const noexcept { return cube ? 6 : 1; }
};

/// A 2D image or a cube, with a view of the whole image and its memory. Movable. Its device must outlive it.
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

/// The use of an image before or after a barrier.
struct ImageUse {
  VkPipelineStageFlags2 stage = VK_PIPELINE_STAGE_2_NONE;
  VkAccessFlags2 access = VK_ACCESS_2_NONE;
  VkImageLayout layout = VK_IMAGE_LAYOUT_UNDEFINED;
};

struct MipRange {
  std::uint32_t first = 0, count = VK_REMAINING_MIP_LEVELS;
};

/// Makes writes of `before` visible to `after` and changes the image layout. Layout UNDEFINED in `before` discards the
/// contents.
void barrier(VkCommandBuffer commands, VkImage image, VkImageAspectFlags aspect, const ImageUse& before,
             const ImageUse& after, const MipRange& levels = {});

/// Copies a whole image in layout TRANSFER_SRC_OPTIMAL to a buffer: tight rows, the top row first. The CPU may read the
/// buffer after the commands have finished.
void read_back(VkCommandBuffer commands, VkImage image, VkExtent2D extent, VkBuffer to);

VkImageAspectFlags aspect_of(VkFormat format) noexcept;

}  // namespace sinew::viewer
