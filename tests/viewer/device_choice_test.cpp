// SPDX-License-Identifier: MIT
#include "viewer/device/device_choice.h"

#include <gmock/gmock.h>

#include "tests/viewer/own_driver.h"
#include "viewer/device/device.h"

namespace sinew::viewer {
namespace {

using testing::HasSubstr;

class device_choice : public OwnDriverTest {
 protected:
  static std::string chosen(VkSurfaceKHR surface = VK_NULL_HANDLE) {
    VkPhysicalDeviceProperties properties{};
    vkGetPhysicalDeviceProperties(choose_device(VK_NULL_HANDLE, surface).physical, &properties);
    return properties.deviceName;
  }
  static std::string refusal(VkSurfaceKHR surface = VK_NULL_HANDLE) {
    try {
      choose_device(VK_NULL_HANDLE, surface);
    } catch (const DeviceError& error) {
      return error.what();
    }
    return "none";
  }
  const VkSurfaceKHR surface_ = reinterpret_cast<VkSurfaceKHR>(std::size_t{1});
};

TEST_F(device_choice, takes_the_best_kind_in_either_order_and_the_first_of_equals) {
  const std::vector<VkPhysicalDeviceType> kinds = {
      VK_PHYSICAL_DEVICE_TYPE_OTHER, VK_PHYSICAL_DEVICE_TYPE_CPU, VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU,
      VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU, VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU};
  for (std::size_t a = 0; a < kinds.size(); ++a)
    for (std::size_t b = 0; b < kinds.size(); ++b) {
      own_driver().devices = {OwnDevice("first", kinds[a]), OwnDevice("second", kinds[b])};
      EXPECT_EQ(chosen(), a >= b ? "first" : "second") << a << ' ' << b;
    }
}

TEST_F(device_choice, says_what_each_device_lacks) {
  own_driver().devices.clear();
  EXPECT_EQ(refusal(), "Vulkan: no device can draw this: none is installed");
  auto& devices = own_driver().devices;
  devices.emplace_back("old").properties.apiVersion = VK_API_VERSION_1_2;
  devices.emplace_back("fixed").dynamic_rendering = false;
  devices.emplace_back("unsynced").synchronization2 = false;
  devices.emplace_back("blended").features.independentBlend = VK_FALSE;
  devices.emplace_back("copying").queues[0].queueFlags = VK_QUEUE_TRANSFER_BIT;
  const std::string all =
      "Vulkan: no device can draw this:\n  old lacks Vulkan 1.3\n  fixed lacks dynamic rendering\n"
      "  unsynced lacks synchronization2\n  blended lacks independent blending\n"
      "  copying lacks a queue that draws and presents";
  EXPECT_EQ(refusal(), all);
  devices.emplace_back("last").properties.deviceType = VK_PHYSICAL_DEVICE_TYPE_OTHER;
  EXPECT_EQ(chosen(), "last") << "a lesser one that lacks nothing";
}

TEST_F(device_choice, does_not_ask_a_device_that_went_away) {
  own_driver().devices = {OwnDevice("stays", VK_PHYSICAL_DEVICE_TYPE_CPU), OwnDevice("leaves")};
  own_driver().leaving = 1;
  EXPECT_EQ(chosen(), "stays");
}

TEST_F(device_choice, needs_swapchains_only_for_a_surface) {
  own_driver().devices[0].extensions.pop_back();
  EXPECT_EQ(chosen(), "own");
  EXPECT_THAT(refusal(surface_), HasSubstr("own lacks swapchains"));
  own_driver().devices[0].extensions = {"VK_KHR_another", VK_KHR_SWAPCHAIN_EXTENSION_NAME, "VK_KHR_third"};
  EXPECT_EQ(chosen(surface_), "own");
}

TEST_F(device_choice, takes_the_first_queue_that_draws_and_presents_to_the_surface) {
  OwnDevice& device = own_driver().devices[0];
  device.queues = {{VK_QUEUE_TRANSFER_BIT | VK_QUEUE_COMPUTE_BIT, 1, 10, {}},
                   {VK_QUEUE_GRAPHICS_BIT, 1, 20, {}},
                   {VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_TRANSFER_BIT, 1, 30, {}}};
  device.presents = {true, false, true};
  const DeviceChoice headless = choose_device(VK_NULL_HANDLE, VK_NULL_HANDLE);
  EXPECT_EQ(headless.queue_family, 1u);
  EXPECT_EQ(headless.timestamp_bits, 20u);
  const DeviceChoice presenting = choose_device(VK_NULL_HANDLE, surface_);
  EXPECT_EQ(presenting.queue_family, 2u);
  EXPECT_EQ(presenting.timestamp_bits, 30u);
  device.presents = {true, false, false};
  EXPECT_THAT(refusal(surface_), HasSubstr("own lacks a queue that draws and presents"));
}

class own_device : public OwnDriverTest {};

TEST_F(own_device, has_the_features_that_there_are) {
  OwnDevice& own = own_driver().devices[0];
  own.properties.limits.maxSamplerAnisotropy = 16.0f;
  own.properties.limits.pointSizeRange[1] = 64.0f;
  for (const bool offered : {false, true}) {
    own.features.samplerAnisotropy = own.features.largePoints = own.features.fullDrawIndexUint32 = offered;
    const Device device;
    EXPECT_EQ(device.max_anisotropy(), offered ? 16.0f : 1.0f);
    EXPECT_EQ(device.max_point_size(), offered ? 64.0f : 1.0f);
    EXPECT_EQ(own_driver().enabled.samplerAnisotropy, offered);
    EXPECT_EQ(own_driver().enabled.largePoints, offered);
    EXPECT_EQ(own_driver().enabled.fullDrawIndexUint32, offered);
    EXPECT_TRUE(own_driver().enabled.independentBlend);
    EXPECT_EQ(own_driver().device_info.enabledExtensionCount, 0u) << "swapchains are for surfaces";
    EXPECT_EQ(own_driver().device_info.queueCreateInfoCount, 1u);
  }
}

TEST_F(own_device, knows_its_name_its_kind_and_its_queue) {
  own_driver().devices = {OwnDevice("painter", VK_PHYSICAL_DEVICE_TYPE_CPU)};
  own_driver().devices[0].queues = {{VK_QUEUE_TRANSFER_BIT, 1, 0, {}}, {VK_QUEUE_GRAPHICS_BIT, 1, 36, {}}};
  const Device device({.make_surface = [](VkInstance) { return own_surface(); }});
  EXPECT_EQ(device.name(), "painter");
  EXPECT_TRUE(device.is_software());
  EXPECT_EQ(device.queue_family(), 1u);
  EXPECT_EQ(device.timestamp_bits(), 36u);
  EXPECT_NE(device.queue(), VK_NULL_HANDLE);
  device.wait_idle();
  EXPECT_EQ(own_driver().waits, 1);
  EXPECT_EQ(own_driver().device_info.enabledExtensionCount, 1u);
}

TEST_F(own_device, that_cannot_draw_leaves_nothing_behind) {
  own_driver().devices[0].dynamic_rendering = false;
  EXPECT_THROW(Device({.make_surface = [](VkInstance) { return own_surface(); }}), DeviceError);
  EXPECT_EQ(own_driver().alive, 0) << "neither instance nor surface";
}

TEST_F(own_device, of_an_older_loader_is_an_error) {
  own_driver().loader_version = VK_API_VERSION_1_2;
  EXPECT_THROW(Device{}, DeviceError);
  own_driver().loader_version = VK_MAKE_API_VERSION(0, 1, 4, 0);
  EXPECT_FALSE(Device{}.is_software());
}

}  // namespace
}  // namespace sinew::viewer
