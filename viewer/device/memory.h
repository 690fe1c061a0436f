// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "viewer/device/device_error.h"

namespace sinew::viewer {

/// Intended use of memory; it decides the memory type.
enum class MemoryUse : std::uint8_t {
  device,    ///< written once by a copy, read by the GPU
  upload,    ///< written by the CPU every frame, read by the GPU; mapped and coherent
  read_back  ///< written by the GPU, read by the CPU; mapped, coherent, and cached if the device has such memory
};

/// A piece of device memory. Return it with Memory::free.
struct MemoryPiece {
  VkDeviceMemory memory = VK_NULL_HANDLE;
  VkDeviceSize offset = 0;
  std::byte* mapped = nullptr;  ///< null for MemoryUse::device
  std::uint32_t block = 0;
};

/// The device's memory types for a use, best first. The later ones are fallbacks: host-visible memory of a graphics
/// card may be only 256 MB; system memory works, but is slower.
/// in   allowed  one bit per type, as in VkMemoryRequirements
std::vector<std::uint32_t> memory_types_for(const VkPhysicalDeviceMemoryProperties& properties, std::uint32_t allowed,
                                            MemoryUse use);

/// Suballocates device memory from blocks, because drivers limit the number of allocations. A block is filled from
/// front to back and freed with its last piece. Buffers and images never share a block, so bufferImageGranularity does
/// not matter.
class Memory {
 public:
  Memory(VkPhysicalDevice physical, VkDevice device);
  ~Memory();
  Memory(const Memory&) = delete;
  Memory& operator=(const Memory&) = delete;

  /// err  DeviceError if no suitable memory is left
  MemoryPiece allocate(const VkMemoryRequirements& needs, MemoryUse use, bool image);
  void free(const MemoryPiece& piece) noexcept;

  std::size_t block_count() const noexcept;  ///< blocks allocated now

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
