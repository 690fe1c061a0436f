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

/// The best device that can run the passes and, with a surface, present to it: discrete before integrated before
/// virtual before software. Among equals, the first in the driver's order.
/// err  DeviceError, which lists what each device lacks
DeviceChoice choose_device(VkInstance instance, VkSurfaceKHR surface);

}  // namespace sinew::viewer
