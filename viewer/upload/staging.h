// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "viewer/device/buffer.h"
#include "viewer/device/image.h"
#include "viewer/upload/mip_chain.h"

namespace sinew::viewer {

/// Collects copies to device memory and submits them together: once for a whole scene, or whenever 64 MiB are
/// collected, so that the staging memory stays small.
class Staging {
 public:
  explicit Staging(const Device& device) : device_(device) {}

  void copy(const Buffer& to, std::span<const std::byte> bytes);
  void copy(const GpuImage& to, std::span<const MipLevel> levels);  ///< fragment shaders can read it afterwards
  void send();                                                      ///< submits, and waits until all copies are done
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
