// SPDX-License-Identifier: MIT
#include "viewer/device/memory.h"

#include <gtest/gtest.h>

#include <initializer_list>
#include <vector>

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

/// Memory types as drivers of graphics cards list them: system memory that cannot be mapped, memory of the card, two
/// kinds of mapped system memory, and the part of the card's memory that the CPU can write.
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

}  // namespace
}  // namespace sinew::viewer
