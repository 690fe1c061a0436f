// SPDX-License-Identifier: MIT
#include "viewer/device/memory.h"

#include <algorithm>

namespace sinew::viewer {

namespace {

constexpr VkDeviceSize kBlockBytes = VkDeviceSize{32} << 20;

VkDeviceSize round_up(VkDeviceSize value, VkDeviceSize alignment) {
  return (value + alignment - 1) / alignment * alignment;
}

/// Property flags in falling order of preference; the first that the device has is taken.
std::vector<VkMemoryPropertyFlags> wishes(MemoryUse use) {
  constexpr VkMemoryPropertyFlags local = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
  constexpr VkMemoryPropertyFlags mapped = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
  switch (use) {
    case MemoryUse::upload: return {mapped | local, mapped};
    case MemoryUse::read_back: return {mapped | VK_MEMORY_PROPERTY_HOST_CACHED_BIT, mapped};
    default: return {local, 0};
  }
}

}  // namespace

Memory::Memory(VkPhysicalDevice physical, VkDevice device) : device_(device) {
  vkGetPhysicalDeviceMemoryProperties(physical, &properties_);
}

Memory::~Memory() {
  for (const Block& block : blocks_)
    if (block.memory) vkFreeMemory(device_, block.memory, nullptr);
}

std::uint32_t Memory::type_for(std::uint32_t allowed, MemoryUse use) const {
  for (const VkMemoryPropertyFlags wish : wishes(use))
    for (std::uint32_t type = 0; type < properties_.memoryTypeCount; ++type)
      if ((allowed >> type & 1u) && (properties_.memoryTypes[type].propertyFlags & wish) == wish) return type;
  throw DeviceError("Vulkan: no memory type fits");
}

Memory::Block Memory::make_block(VkDeviceSize size, std::uint32_t type, MemoryUse use, bool image) const {
  Block block;
  block.size = size, block.type = type, block.image = image;
  VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
  info.allocationSize = size;
  info.memoryTypeIndex = type;
  must(vkAllocateMemory(device_, &info, nullptr, &block.memory), "vkAllocateMemory");
  if (use == MemoryUse::device) return block;
  void* mapped = nullptr;
  const VkResult result = vkMapMemory(device_, block.memory, 0, VK_WHOLE_SIZE, 0, &mapped);
  if (result < 0) vkFreeMemory(device_, block.memory, nullptr);
  must(result, "vkMapMemory");
  block.mapped = static_cast<std::byte*>(mapped);
  return block;
}

MemoryPiece Memory::allocate(const VkMemoryRequirements& needs, MemoryUse use, bool image) {
  const std::scoped_lock lock(mutex_);
  const std::uint32_t type = type_for(needs.memoryTypeBits, use);
  const bool mapped = use != MemoryUse::device;
  std::size_t at = blocks_.size();
  for (std::size_t i = 0; i < blocks_.size() && at == blocks_.size(); ++i) {
    const Block& block = blocks_[i];
    const bool fits = block.memory && block.type == type && block.image == image && (block.mapped != nullptr) == mapped;
    if (fits && round_up(block.used, needs.alignment) + needs.size <= block.size) at = i;
  }
  if (at == blocks_.size()) {
    at = static_cast<std::size_t>(
        std::find_if(blocks_.begin(), blocks_.end(), [](const Block& b) { return !b.memory; }) - blocks_.begin());
    // A large piece gets a block of its own, so that it goes back to the driver alone.
    const VkDeviceSize size = needs.size > kBlockBytes / 4 ? needs.size : kBlockBytes;
    Block block = make_block(size, type, use, image);
    if (at == blocks_.size())
      blocks_.push_back(block);
    else
      blocks_[at] = block;
  }
  Block& block = blocks_[at];
  MemoryPiece piece;
  piece.memory = block.memory;
  piece.offset = round_up(block.used, needs.alignment);
  piece.mapped = block.mapped ? block.mapped + piece.offset : nullptr;
  piece.block = static_cast<std::uint32_t>(at);
  block.used = piece.offset + needs.size;
  ++block.pieces;
  return piece;
}

void Memory::free(const MemoryPiece& piece) noexcept {
  const std::scoped_lock lock(mutex_);
  Block& block = blocks_[piece.block];
  if (--block.pieces > 0) return;
  vkFreeMemory(device_, block.memory, nullptr);
  block = Block{};
}

std::size_t Memory::block_count() const noexcept {
  const std::scoped_lock lock(mutex_);
  return static_cast<std::size_t>(
      std::count_if(blocks_.begin(), blocks_.end(), [](const Block& b) { return b.memory != VK_NULL_HANDLE; }));
}

}  // namespace sinew::viewer
