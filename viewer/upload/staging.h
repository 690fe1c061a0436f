// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "viewer/device/buffer.h"
#include "viewer/device/image.h"
#include "viewer/upload/mip_chain.h"

namespace sinew::viewer {

/// Copies to device memory, collected and then sent together: one submit for a whole scene, or one whenever the
/// collected bytes exceed a bound, so that large textures need no second copy of everything.
class Staging {
 public:
  explicit Staging(const Device& device) : device_(device) {}

  void copy(const Buffer& to, std::span<const std::byte> bytes);
  void copy(const GpuImage& to, std::span<const MipLevel> levels);  ///< leaves it readable by fragment shaders
  void send();                                                      ///< waits until all has arrived

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
