// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <vulkan/vulkan.h>

namespace sinew::viewer {

/// A device of the test's own driver. As it is made, it can run the passes.
struct OwnDevice {
  VkPhysicalDeviceProperties properties{};
  VkPhysicalDeviceFeatures features{};
  bool dynamic_rendering = true, synchronization2 = true;
  std::vector<VkQueueFamilyProperties> queues;
  std::vector<bool> presents;  ///< of each queue family; true where none is named
  std::vector<std::string> extensions;

  explicit OwnDevice(const std::string& name = "own", VkPhysicalDeviceType type = VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU);
};

/// The test's own driver: a program that has own_driver.cpp calls its functions in place of those of the Vulkan
/// library. It answers as the test says, and notes what it is asked for.
struct OwnDriver {
  std::vector<OwnDevice> devices;
  std::uint32_t loader_version = VK_API_VERSION_1_3;
  std::uint32_t leaving = 0;  ///< devices that go away while they are listed

  VkPhysicalDeviceMemoryProperties memory{};
  std::vector<VkDeviceSize> room;               ///< bytes of each type; without end where none is named
  bool maps = true;                             ///< whether memory can be mapped
  std::vector<VkMemoryAllocateInfo> allocated;  ///< in order, those that failed left out
  std::vector<VkDeviceMemory> freed;            ///< in order
  VkResult on_bind = VK_SUCCESS, on_view = VK_SUCCESS;

  std::vector<VkSurfaceFormatKHR> formats;
  VkSurfaceCapabilitiesKHR surface{};
  std::vector<VkSwapchainCreateInfoKHR> swapchains;  ///< as they were asked for
  VkResult on_acquire = VK_SUCCESS, on_present = VK_SUCCESS;
  std::vector<VkImageViewCreateInfo> views;  ///< as they were asked for
  int waits = 0;                             ///< until the device is idle
  std::vector<std::uint32_t> presented;
  VkSemaphore waited_for = VK_NULL_HANDLE;  ///< by what was shown last
  VkSwapchainKHR shown_on = VK_NULL_HANDLE;

  std::vector<std::uint64_t> ticks;  ///< what the queries hold
  std::vector<std::uint32_t> marks;  ///< queries that were written, in order
  VkQueryResultFlags query_flags = 0;

  VkDeviceCreateInfo device_info{};  ///< its pointers are dead
  VkPhysicalDeviceFeatures enabled{};
  std::uint32_t queue_family = ~0u;
  std::function<void(const VkGraphicsPipelineCreateInfo&)> on_pipeline;

  int alive = 0;  ///< objects that were made and not destroyed
};

OwnDriver& own_driver();

/// A surface that nothing is shown on; destroyed with the device that it is given to.
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
