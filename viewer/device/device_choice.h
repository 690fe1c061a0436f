// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "viewer/device/device_error.h"

namespace sinew::viewer {

struct DeviceChoice {
  VkPhysicalDevice physical = VK_NULL_HANDLE;
  std::uint32_t queue_family = 0;
  std::uint32_t timestamp_bits = 0;
};

/// Chooses a suitable device that can also present to the surface, if one is given. Prefers discrete, then integrated,
/// virtual and software devices; among equals, the first listed.
/// err  DeviceError, which lists what each device lacks
DeviceChoice choose_device(VkInstance instance, VkSurfaceKHR surface);

}  // namespace sinew::viewer
