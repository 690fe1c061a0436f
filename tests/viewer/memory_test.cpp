// SPDX-License-Identifier: MIT
#include "viewer/device/memory.h"

#include <gmock/gmock.h>

#include <initializer_list>
#include <vector>

#include "tests/viewer/own_driver.h"

namespace sinew::viewer {
namespace {

constexpr VkMemoryPropertyFlags kLocal = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
constexpr VkMemoryPropertyFlags kMapped = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
constexpr VkMemoryPropertyFlags kCached = VK_MEMORY_PROPERTY_HOST_CACHED_BIT;
constexpr std::uint32_t kAll = ~0u;

VkPhysicalDeviceMemoryProperties device_with(std::initializer_list<VkMemoryPropertyFlags> types) {
  VkPhysicalDeviceMemoryProperties properties{};
  for (const VkMemoryPropertyFlags flags : types)
    properties.memoryTypes[properties.memoryTypeCount++].propertyFlags = flags;
  return properties;
}

using Types = std::vector<std::uint32_t>;

/// Memory types as in drivers of graphics cards. In order: unmappable system memory, card memory, two kinds of mapped
/// system memory, and card memory that the CPU can write.
VkPhysicalDeviceMemoryProperties card() {
  return device_with({0, kLocal, kMapped, kMapped | kCached, kLocal | kMapped});
}

TEST(memory_types, on_a_card_are_its_own_memory_first_and_the_systems_when_that_is_full) {
  EXPECT_EQ(memory_types_for(card(), kAll, MemoryUse::device), (Types{1, 4, 0, 2, 3}));
  EXPECT_EQ(memory_types_for(card(), kAll, MemoryUse::upload), (Types{4, 2, 3}));
  EXPECT_EQ(memory_types_for(card(), kAll, MemoryUse::read_back), (Types{3, 2, 4}));
}

TEST(memory_types, are_among_the_allowed_ones) {
  EXPECT_EQ(memory_types_for(card(), 1u << 1 | 1u << 2, MemoryUse::device), (Types{1, 2}));
  EXPECT_EQ(memory_types_for(card(), 1u << 1 | 1u << 2, MemoryUse::upload), (Types{2}));
  EXPECT_EQ(memory_types_for(card(), 1u << 1, MemoryUse::upload), Types{});
}

TEST(memory_types, of_a_processor_that_draws_are_its_only_one) {
  for (const MemoryUse use : {MemoryUse::device, MemoryUse::upload, MemoryUse::read_back})
    EXPECT_EQ(memory_types_for(device_with({kLocal | kMapped | kCached}), kAll, use), Types{0});
}

TEST(memory_types, that_must_be_flushed_are_not_mapped) {
  EXPECT_EQ(
      memory_types_for(device_with({kLocal | VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT, kMapped}), kAll, MemoryUse::upload),
      (Types{1}));
}

TEST(memory_types, of_features_that_are_off_are_left_out) {
  EXPECT_EQ(memory_types_for(device_with({kLocal | VK_MEMORY_PROPERTY_PROTECTED_BIT,
                                          kLocal | VK_MEMORY_PROPERTY_DEVICE_COHERENT_BIT_AMD, kLocal}),
                             kAll, MemoryUse::device),
            (Types{2}));
}

constexpr VkDeviceSize kMegabyte = VkDeviceSize{1} << 20;

class memory_blocks : public OwnDriverTest {
 protected:
  void SetUp() override {
    OwnDriverTest::SetUp();
    own_driver().memory = card();
  }
  static VkMemoryRequirements needs(VkDeviceSize size, VkDeviceSize alignment = 1, std::uint32_t types = kAll) {
    return {size, alignment, types};
  }
  /// Types and sizes of the allocated blocks.
  static std::vector<std::pair<std::uint32_t, VkDeviceSize>> made() {
    std::vector<std::pair<std::uint32_t, VkDeviceSize>> blocks;
    for (const VkMemoryAllocateInfo& info : own_driver().allocated)
      blocks.emplace_back(info.memoryTypeIndex, info.allocationSize);
    return blocks;
  }
};

TEST_F(memory_blocks, hold_pieces_one_behind_the_other_at_their_alignment) {
  Memory memory(VK_NULL_HANDLE, VK_NULL_HANDLE);
  const MemoryPiece a = memory.allocate(needs(100), MemoryUse::device, false);
  const MemoryPiece b = memory.allocate(needs(10, 64), MemoryUse::device, false);
  const MemoryPiece c = memory.allocate(needs(10, 1), MemoryUse::device, false);
  const MemoryPiece d = memory.allocate(needs(10, 69), MemoryUse::device, false);
  EXPECT_EQ(a.offset, 0u);
  EXPECT_EQ(b.offset, 128u);
  EXPECT_EQ(c.offset, 138u);
  EXPECT_EQ(d.offset, 207u) << "the next multiple of 69, and 148 is none";
  for (const MemoryPiece& piece : {b, c, d}) EXPECT_EQ(piece.memory, a.memory);
  EXPECT_EQ(a.mapped, nullptr);
  EXPECT_THAT(made(), testing::ElementsAre(std::pair(1u, 32 * kMegabyte)));
  EXPECT_EQ(memory.block_count(), 1u);
}

TEST_F(memory_blocks, are_filled_to_the_last_byte_and_no_further) {
  Memory memory(VK_NULL_HANDLE, VK_NULL_HANDLE);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(memory.allocate(needs(8 * kMegabyte), MemoryUse::device, false).block, 0u);
  EXPECT_EQ(memory.allocate(needs(1), MemoryUse::device, false).block, 1u);
  EXPECT_EQ(memory.allocate(needs(8 * kMegabyte - 1, 2), MemoryUse::device, false).offset, 2u);
  EXPECT_EQ(memory.block_count(), 2u);
  memory.allocate(needs(8 * kMegabyte, 1), MemoryUse::device, false);
  memory.allocate(needs(8 * kMegabyte, 1), MemoryUse::device, false);
  memory.allocate(needs(8 * kMegabyte - 101, 1), MemoryUse::device, false);
  EXPECT_EQ(memory.allocate(needs(100, 64), MemoryUse::device, false).block, 2u) << "from its alignment on";
  EXPECT_EQ(memory.allocate(needs(100, 1), MemoryUse::device, false).block, 1u);
}

TEST_F(memory_blocks, of_large_pieces_are_their_own) {
  Memory memory(VK_NULL_HANDLE, VK_NULL_HANDLE);
  memory.allocate(needs(8 * kMegabyte + 1), MemoryUse::device, false);
  memory.allocate(needs(40 * kMegabyte), MemoryUse::device, false);
  EXPECT_THAT(made(), testing::ElementsAre(std::pair(1u, 8 * kMegabyte + 1), std::pair(1u, 40 * kMegabyte)));
}

TEST_F(memory_blocks, are_shared_neither_by_buffers_and_images_nor_by_types_nor_with_what_is_mapped) {
  own_driver().memory = device_with({kLocal | kMapped | kCached, kLocal});
  Memory memory(VK_NULL_HANDLE, VK_NULL_HANDLE);
  const MemoryPiece buffer = memory.allocate(needs(10), MemoryUse::device, false);
  const MemoryPiece image = memory.allocate(needs(10), MemoryUse::device, true);
  const MemoryPiece mapped = memory.allocate(needs(10), MemoryUse::upload, false);
  const MemoryPiece other_type = memory.allocate(needs(10, 1, 2), MemoryUse::device, false);
  EXPECT_EQ(memory.block_count(), 4u);
  EXPECT_EQ(memory.allocate(needs(10), MemoryUse::device, false).block, buffer.block);
  EXPECT_EQ(memory.allocate(needs(10), MemoryUse::device, true).block, image.block);
  const MemoryPiece second = memory.allocate(needs(10, 4), MemoryUse::read_back, false);
  EXPECT_EQ(second.block, mapped.block);
  EXPECT_EQ(second.mapped, mapped.mapped + 12);
  EXPECT_EQ(memory.allocate(needs(10, 1, 2), MemoryUse::device, false).block, other_type.block);
}

TEST_F(memory_blocks, are_freed_with_their_last_piece_and_their_places_used_again) {
  Memory memory(VK_NULL_HANDLE, VK_NULL_HANDLE);
  const MemoryPiece a = memory.allocate(needs(10), MemoryUse::device, false);
  const MemoryPiece b = memory.allocate(needs(10), MemoryUse::device, false);
  const MemoryPiece image = memory.allocate(needs(10), MemoryUse::device, true);
  memory.free(a);
  EXPECT_THAT(own_driver().freed, testing::IsEmpty());
  EXPECT_EQ(memory.allocate(needs(10), MemoryUse::device, false).offset, 20u) << "its place is not used again before";
  memory.free(b);
  EXPECT_EQ(memory.block_count(), 2u);
  memory.free(b);  // the third piece, in the same block
  EXPECT_THAT(own_driver().freed, testing::ElementsAre(a.memory));
  EXPECT_EQ(memory.block_count(), 1u);
  const MemoryPiece again = memory.allocate(needs(10), MemoryUse::device, false);
  EXPECT_EQ(again.block, a.block);
  EXPECT_EQ(again.offset, 0u);
  memory.free(image);
  EXPECT_EQ(own_driver().freed.back(), image.memory) << "whose place stayed";
}

TEST_F(memory_blocks, come_from_the_next_type_when_one_is_full_and_from_none_when_all_are) {
  own_driver().room = {0, 32 * kMegabyte, 0, 9 * kMegabyte, 10 * kMegabyte};
  Memory memory(VK_NULL_HANDLE, VK_NULL_HANDLE);
  memory.allocate(needs(30 * kMegabyte), MemoryUse::device, false);
  memory.allocate(needs(9 * kMegabyte), MemoryUse::device, false);
  memory.allocate(needs(9 * kMegabyte), MemoryUse::device, false);
  EXPECT_THAT(made(), testing::ElementsAre(std::pair(1u, 30 * kMegabyte), std::pair(4u, 9 * kMegabyte),
                                           std::pair(3u, 9 * kMegabyte)));
  const auto refusal = [&](const VkMemoryRequirements& wanted) {
    try {
      memory.allocate(wanted, MemoryUse::device, false);
    } catch (const DeviceError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(refusal(needs(9 * kMegabyte)), testing::HasSubstr("vkAllocateMemory"));
  EXPECT_THAT(refusal(needs(1, 1, 0)), testing::HasSubstr("no memory type fits"));
  EXPECT_EQ(memory.block_count(), 3u);
}

TEST_F(memory_blocks, that_cannot_be_mapped_are_given_back) {
  own_driver().maps = false;
  Memory memory(VK_NULL_HANDLE, VK_NULL_HANDLE);
  EXPECT_THROW(memory.allocate(needs(10), MemoryUse::upload, false), DeviceError);
  EXPECT_EQ(own_driver().freed.size(), own_driver().allocated.size());
  EXPECT_EQ(memory.block_count(), 0u);
  memory.allocate(needs(10), MemoryUse::device, false);
  EXPECT_EQ(memory.block_count(), 1u) << "what is not written needs no mapping";
}

}  // namespace
}  // namespace sinew::viewer
