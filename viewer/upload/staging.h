// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "viewer/device/buffer.h"
#include "viewer/device/image.h"
#include "viewer/upload/mip_chain.h"

namespace sinew::viewer {

/// Batches copies to device memory. Submits them at send(), or whenever 64 MiB are pending, to bound the staging
/// memory.
class Staging {
 public:
  explicit Staging(const Device& device) : device_(device) {}

  void copy(const Buffer& to, std::span<const std::byte> bytes);
  void copy(const GpuImage& to, std::span<const MipLevel> levels);  ///< the image is then readable in fragment shaders
  void send();                                                      ///< submits all copies and waits for them
  VkDeviceSize waiting_bytes() const noexcept { return pending_; }

 private:
  struct ImageCopy {
    std::size_t staged;
    VkImage image;
    std::vector<VkBufferImageCopy> regions;
  };
  struct BufferCopy {
    std::size_t staged;
    VkBuffer buffer;
    VkDeviceSize bytes;
  };

  const Device& device_;
  std::vector<Buffer> buffers_;
  std::vector<ImageCopy> images_;
  std::vector<BufferCopy> copies_;
  VkDeviceSize pending_ = 0;
};

}  // namespace sinew::viewer
