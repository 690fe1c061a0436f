// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "viewer/device/device_error.h"

namespace sinew::viewer {

/// What memory is for decides where it lies.
enum class MemoryUse : std::uint8_t {
  device,    ///< written once by copies, read by the GPU
  upload,    ///< written by the CPU every frame, read by the GPU; mapped and coherent
  read_back  ///< written by the GPU, read by the CPU; mapped, coherent and cached where the device has it
};

/// A piece of device memory; give it back with Memory::free.
struct MemoryPiece {
  VkDeviceMemory memory = VK_NULL_HANDLE;
  VkDeviceSize offset = 0;
  std::byte* mapped = nullptr;  ///< null for MemoryUse::device
  std::uint32_t block = 0;
};

/// Device memory in blocks: drivers allow few allocations, scenes have many textures. A block is filled front to back
/// and returned when all its pieces are gone; buffers and images never share a block (bufferImageGranularity).
class Memory {
 public:
  Memory(VkPhysicalDevice physical, VkDevice device);
  ~Memory();
  Memory(const Memory&) = delete;
  Memory& operator=(const Memory&) = delete;

  /// err  DeviceError when the device has no memory of that kind left
  MemoryPiece allocate(const VkMemoryRequirements& needs, MemoryUse use, bool image);
  void free(const MemoryPiece& piece) noexcept;

  std::size_t block_count() const noexcept;  ///< live vkAllocateMemory blocks

 private:
  struct Block {
    VkDeviceMemory memory = VK_NULL_HANDLE;
    std::byte* mapped = nullptr;
    VkDeviceSize size = 0, used = 0;
    std::uint32_t type = 0, pieces = 0;
    bool image = false;
  };
  std::uint32_t type_for(std::uint32_t allowed, MemoryUse use) const;
  Block make_block(VkDeviceSize size, std::uint32_t type, MemoryUse use, bool image) const;

  VkDevice device_;
  VkPhysicalDeviceMemoryProperties properties_{};
  std::vector<Block> blocks_;
  mutable std::mutex mutex_;
};

}  // namespace sinew::viewer
