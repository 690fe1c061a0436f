// SPDX-License-Identifier: MIT
#pragma once
#include "viewer/device/device.h"

namespace sinew::viewer {

/// A buffer with its memory. Movable. Its device must outlive it.
class Buffer {
 public:
  Buffer() = default;
  /// in   bytes  size; 0 is raised to 1
  Buffer(const Device& device, VkDeviceSize bytes, VkBufferUsageFlags usage, MemoryUse use);
  ~Buffer() { reset(); }
  Buffer(Buffer&& other) noexcept;
  Buffer& operator=(Buffer&& other) noexcept;

  VkBuffer handle() const noexcept { return buffer_; }
  VkDeviceSize size() const noexcept { return size_; }
  std::byte* mapped() const noexcept { return piece_.mapped; }  ///< null for MemoryUse::device

 private:
  void reset() noexcept;

  const Device* device_ = nullptr;
  VkBuffer buffer_ = VK_NULL_HANDLE;
  VkDeviceSize size_ = 0;
  MemoryPiece piece_;
};

}  // namespace sinew::viewer
