// SPDX-License-Identifier: MIT
#include "viewer/device/buffer.h"

#include <algorithm>
#include <utility>

namespace sinew::viewer {

// Delegates to the default constructor, so that the destructor runs if the body throws.
Buffer::Buffer(const Device& device, VkDeviceSize bytes, VkBufferUsageFlags usage, MemoryUse use) : Buffer() {
  device_ = &device;
  size_ = std::max<VkDeviceSize>(bytes, 1);
  VkBufferCreateInfo info{VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
  info.size = size_;
  info.usage = usage;
  must(vkCreateBuffer(device.handle(), &info, nullptr, &buffer_), "vkCreateBuffer");
  VkMemoryRequirements needs{};
  vkGetBufferMemoryRequirements(device.handle(), buffer_, &needs);
  piece_ = device.memory().allocate(needs, use, false);
  must(vkBindBufferMemory(device.handle(), buffer_, piece_.memory, piece_.offset), "vkBindBufferMemory");
}

Buffer::Buffer(Buffer&& other) noexcept { *this = std::move(other); }

Buffer& Buffer::operator=(Buffer&& other) noexcept {
  if (this == &other) return *this;
  reset();
  device_ = other.device_;
  buffer_ = std::exchange(other.buffer_, VK_NULL_HANDLE);
  size_ = other.size_;
  piece_ = std::exchange(other.piece_, {});
  return *this;
}

void Buffer::reset() noexcept {
  if (!buffer_) return;
  vkDestroyBuffer(device_->handle(), buffer_, nullptr);
  if (piece_.memory) device_->memory().free(piece_);
  buffer_ = VK_NULL_HANDLE;
}

}  // namespace sinew::viewer
