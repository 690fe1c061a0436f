// SPDX-License-Identifier: MIT
#include "viewer/device/device_choice.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

#include "viewer/device/listed.h"

namespace sinew::viewer {

namespace {

int rank(VkPhysicalDeviceType type) {
  switch (type) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU: return 4;
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU: return 3;
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU: return 2;
    case VK_PHYSICAL_DEVICE_TYPE_CPU: return 1;
    default: return 0;
  }
}

std::vector<VkPhysicalDevice> all_devices(VkInstance instance) {
  return listed<VkPhysicalDevice>("vkEnumeratePhysicalDevices", [&](std::uint32_t* count, VkPhysicalDevice* devices) {
    return vkEnumeratePhysicalDevices(instance, count, devices);
  });
}

bool has_swapchains(VkPhysicalDevice device) {
  const auto extensions = listed<VkExtensionProperties>(
      "vkEnumerateDeviceExtensionProperties", [&](std::uint32_t* count, VkExtensionProperties* entries) {
        return vkEnumerateDeviceExtensionProperties(device, nullptr, count, entries);
      });
  return std::any_of(extensions.begin(), extensions.end(), [](const VkExtensionProperties& extension) {
    return std::string_view(extension.extensionName) == VK_KHR_SWAPCHAIN_EXTENSION_NAME;
  });
}

std::optional<DeviceChoice> with_queue(VkPhysicalDevice device, VkSurfaceKHR surface) {
  const auto families =
      listed<VkQueueFamilyProperties>("queue families", [&](std::uint32_t* count, VkQueueFamilyProperties* entries) {
        vkGetPhysicalDeviceQueueFamilyProperties(device, count, entries);
        return VK_SUCCESS;
      });
  for (std::uint32_t family = 0; family < families.size(); ++family) {
    if (!(families[family].queueFlags & VK_QUEUE_GRAPHICS_BIT)) continue;
    VkBool32 presents = VK_TRUE;
    if (surface) must(vkGetPhysicalDeviceSurfaceSupportKHR(device, family, surface, &presents), "surface support");
    if (presents) return DeviceChoice{device, family, families[family].timestampValidBits};
  }
  return std::nullopt;
}

/// The name of the first required feature that a device lacks; null if it is suitable.
const char* lack_of(VkPhysicalDevice device, const VkPhysicalDeviceProperties& properties, VkSurfaceKHR surface) {
  if (properties.apiVersion < VK_API_VERSION_1_3) return "Vulkan 1.3";
  VkPhysicalDeviceVulkan13Features features13{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
  VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &features13, {}};
  vkGetPhysicalDeviceFeatures2(device, &features);
  if (!features13.dynamicRendering) return "dynamic rendering";
  if (!features13.synchronization2) return "synchronization2";
  if (!features.features.independentBlend) return "independent blending";
  if (surface && !has_swapchains(device)) return "swapchains";
  return nullptr;
}

}  // namespace

DeviceChoice choose_device(VkInstance instance, VkSurfaceKHR surface) {
  std::optional<DeviceChoice> best;
  int best_rank = -1;
  std::string lacks;
  for (VkPhysicalDevice device : all_devices(instance)) {
    VkPhysicalDeviceProperties properties{};
    vkGetPhysicalDeviceProperties(device, &properties);
    const char* lack = lack_of(device, properties, surface);
    const std::optional<DeviceChoice> choice = lack ? std::nullopt : with_queue(device, surface);
    if (!choice) {
      lacks +=
          std::string("\n  ") + properties.deviceName + " lacks " + (lack ? lack : "a queue that draws and presents");
      continue;
    }
    if (rank(properties.deviceType) > best_rank) {
      best = choice;
      best_rank = rank(properties.deviceType);
    }
  }
  if (!best)
    throw DeviceError("Vulkan: no device can draw this" +
                      (lacks.empty() ? std::string(": none is installed") : ":" + lacks));
  return *best;
}

}  // namespace sinew::viewer
