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

/// The device's memory types for a use, best first. Where the best is full, the next is taken: the part of a graphics
/// card's memory that the CPU can write may be as small as 256 MB, while the system's own serves as well, only slower.
/// in   allowed  bit per type, as VkMemoryRequirements has them
std::vector<std::uint32_t> memory_types_for(const VkPhysicalDeviceMemoryProperties& properties, std::uint32_t allowed,
                                            MemoryUse use);

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
  std::size_t block_for(const VkMemoryRequirements& needs, MemoryUse use, bool image);
  std::size_t block_with_room(const VkMemoryRequirements& needs, std::uint32_t type, bool mapped, bool image);
  VkResult make_block(VkDeviceSize size, std::uint32_t type, MemoryUse use, bool image, Block& block) const;

  VkDevice device_;
  VkPhysicalDeviceMemoryProperties properties_{};
  std::vector<Block> blocks_;
  mutable std::mutex mutex_;
};

}  // namespace sinew::viewer
