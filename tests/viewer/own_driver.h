// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <vulkan/vulkan.h>

namespace sinew::viewer {

/// A device of the fake driver. By default it is suitable for the viewer.
struct OwnDevice {
  VkPhysicalDeviceProperties properties{};
  VkPhysicalDeviceFeatures features{};
  bool dynamic_rendering = true, synchronization2 = true;
  std::vector<VkQueueFamilyProperties> queues;
  std::vector<bool> presents;  ///< [queue families] can present; missing entries = true
  std::vector<std::string> extensions;

  explicit OwnDevice(const std::string& name = "own", VkPhysicalDeviceType type = VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU);
};

/// A fake driver: programs linked with own_driver.cpp call its functions in place of the Vulkan library's. Tests set
/// its answers and inspect the recorded calls.
struct OwnDriver {
  std::vector<OwnDevice> devices;
  std::uint32_t loader_version = VK_API_VERSION_1_3;
  std::uint32_t leaving = 0;  ///< devices that disappear during enumeration

  VkPhysicalDeviceMemoryProperties memory{};
  std::vector<VkDeviceSize> room;               ///< [memory types] bytes available; missing entries = unlimited
  bool maps = true;                             ///< whether memory can be mapped
  std::vector<VkMemoryAllocateInfo> allocated;  ///< successful allocations, in order
  std::vector<VkDeviceMemory> freed;            ///< in order
  VkResult on_bind = VK_SUCCESS, on_view = VK_SUCCESS;

  std::vector<VkSurfaceFormatKHR> formats;
  VkSurfaceCapabilitiesKHR surface{};
  std::vector<VkSwapchainCreateInfoKHR> swapchains;  ///< requested, in order
  VkResult on_acquire = VK_SUCCESS, on_present = VK_SUCCESS;
  std::vector<VkImageViewCreateInfo> views;  ///< requested, in order
  int waits = 0;                             ///< number of waits for an idle device
  std::vector<std::uint32_t> presented;
  VkSemaphore waited_for = VK_NULL_HANDLE;  ///< semaphore that the last present waited for
  VkSwapchainKHR shown_on = VK_NULL_HANDLE;

  std::vector<std::uint64_t> ticks;  ///< values of the queries
  std::vector<std::uint32_t> marks;  ///< written queries, in order
  VkQueryResultFlags query_flags = 0;

  VkDeviceCreateInfo device_info{};  ///< its pointers are dangling
  VkPhysicalDeviceFeatures enabled{};
  std::uint32_t queue_family = ~0u;
  std::function<void(const VkGraphicsPipelineCreateInfo&)> on_pipeline;

  int alive = 0;  ///< number of live objects
};

OwnDriver& own_driver();

/// A fake surface; destroyed together with the device that receives it.
VkSurfaceKHR own_surface();

/// Base of tests on a driver with one device.
class OwnDriverTest : public testing::Test {
 protected:
  void SetUp() override {
    own_driver() = {};
    own_driver().devices.emplace_back();
  }
  void TearDown() override { EXPECT_EQ(own_driver().alive, 0) << "what is made is destroyed, once"; }
};

}  // namespace sinew::viewer
