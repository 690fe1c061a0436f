// SPDX-License-Identifier: MIT
#include "viewer/device/memory.h"

#include <algorithm>

namespace sinew::viewer {

namespace {

constexpr VkDeviceSize kBlockBytes = VkDeviceSize{32} << 20;

/// Memory types with any other property flag need features that are not enabled: protected memory, AMD's uncached
/// memory, transient attachments.
constexpr VkMemoryPropertyFlags kUsableFlags =
    VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT | VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT |
    VK_MEMORY_PROPERTY_HOST_CACHED_BIT;

VkDeviceSize round_up(VkDeviceSize value, VkDeviceSize alignment) {
  return (value + alignment - 1) / alignment * alignment;
}

/// Property flags to try, in order of preference.
std::vector<VkMemoryPropertyFlags> preferred_flags(MemoryUse use) {
  constexpr VkMemoryPropertyFlags local = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
  constexpr VkMemoryPropertyFlags mapped = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
  switch (use) {
    case MemoryUse::upload: return {mapped | local, mapped};
    case MemoryUse::read_back: return {mapped | VK_MEMORY_PROPERTY_HOST_CACHED_BIT, mapped};
    default: return {local, 0};
  }
}

}  // namespace

std::vector<std::uint32_t> memory_types_for(const VkPhysicalDeviceMemoryProperties& properties, std::uint32_t allowed,
                                            MemoryUse use) {
  std::vector<std::uint32_t> types;
  for (const VkMemoryPropertyFlags preferred : preferred_flags(use))
    for (std::uint32_t type = 0; type < properties.memoryTypeCount; ++type) {
      const VkMemoryPropertyFlags flags = properties.memoryTypes[type].propertyFlags;
      const bool fits = (allowed >> type & 1u) && (flags & preferred) == preferred && (flags & ~kUsableFlags) == 0;
      if (fits && std::find(types.begin(), types.end(), type) == types.end()) types.push_back(type);
    }
  return types;
}

Memory::Memory(VkPhysicalDevice physical, VkDevice device) : device_(device) {
  vkGetPhysicalDeviceMemoryProperties(physical, &properties_);
}

Memory::~Memory() {
  for (const Block& block : blocks_) vkFreeMemory(device_, block.memory, nullptr);  // null where it was freed
}

VkResult Memory::make_block(VkDeviceSize size, std::uint32_t type, MemoryUse use, bool image, Block& block) const {
  block.size = size;
  block.type = type;
  block.image = image;
  VkMemoryAllocateInfo info{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
  info.allocationSize = size;
  info.memoryTypeIndex = type;
  VkResult result = vkAllocateMemory(device_, &info, nullptr, &block.memory);
  if (result != VK_SUCCESS || use == MemoryUse::device) return result;
  void* mapped = nullptr;
  result = vkMapMemory(device_, block.memory, 0, VK_WHOLE_SIZE, 0, &mapped);
  if (result != VK_SUCCESS) vkFreeMemory(device_, block.memory, nullptr);
  block.mapped = static_cast<std::byte*>(mapped);
  return result;
}

/// Index of a block of this kind with room for the piece; blocks_.size() if there is none.
std::size_t Memory::block_with_room(const VkMemoryRequirements& needs, std::uint32_t type, bool mapped, bool image) {
  const auto has_room = [&](const Block& block) {
    const bool is_kind =
        block.memory && block.type == type && block.image == image && (block.mapped != nullptr) == mapped;
    return is_kind && round_up(block.used, needs.alignment) + needs.size <= block.size;
  };
  return static_cast<std::size_t>(std::find_if(blocks_.begin(), blocks_.end(), has_room) - blocks_.begin());
}

/// Index of a block for the piece: an existing one with room, else a new one of the best memory type that still has
/// space.
std::size_t Memory::block_for(const VkMemoryRequirements& needs, MemoryUse use, bool image) {
  // A large piece gets its own block, so that freeing the piece frees the block.
  const VkDeviceSize size = needs.size > kBlockBytes / 4 ? needs.size : kBlockBytes;
  VkResult result = VK_SUCCESS;
  for (const std::uint32_t type : memory_types_for(properties_, needs.memoryTypeBits, use)) {
    const std::size_t there = block_with_room(needs, type, use != MemoryUse::device, image);
    if (there < blocks_.size()) return there;
    Block made;
    result = make_block(size, type, use, image, made);
    if (result != VK_SUCCESS) continue;
    auto at = std::find_if(blocks_.begin(), blocks_.end(), [](const Block& b) { return !b.memory; });
    if (at == blocks_.end()) at = blocks_.emplace(at);
    *at = made;
    return static_cast<std::size_t>(at - blocks_.begin());
  }
  must(result, "vkAllocateMemory");
  throw DeviceError("Vulkan: no memory type fits");  // reached only if the list of types is empty
}

MemoryPiece Memory::allocate(const VkMemoryRequirements& needs, MemoryUse use, bool image) {
  const std::scoped_lock lock(mutex_);
  const std::size_t at = block_for(needs, use, image);
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
