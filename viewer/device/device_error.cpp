// SPDX-License-Identifier: MIT
#include "viewer/device/device_error.h"

namespace sinew::viewer {

namespace {

const char* name_of(VkResult result) {
  switch (result) {
    case VK_ERROR_OUT_OF_HOST_MEMORY: return "out of host memory";
    case VK_ERROR_OUT_OF_DEVICE_MEMORY: return "out of device memory";
    case VK_ERROR_INITIALIZATION_FAILED: return "initialisation failed";
    case VK_ERROR_DEVICE_LOST: return "device lost";
    case VK_ERROR_LAYER_NOT_PRESENT: return "layer not present";
    case VK_ERROR_EXTENSION_NOT_PRESENT: return "extension not present";
    case VK_ERROR_FEATURE_NOT_PRESENT: return "feature not present";
    case VK_ERROR_INCOMPATIBLE_DRIVER: return "no Vulkan driver is installed";
    case VK_ERROR_TOO_MANY_OBJECTS: return "too many objects";
    case VK_ERROR_FORMAT_NOT_SUPPORTED: return "format not supported";
    case VK_ERROR_OUT_OF_POOL_MEMORY: return "out of pool memory";
    case VK_ERROR_FRAGMENTED_POOL: return "fragmented pool";
    case VK_ERROR_SURFACE_LOST_KHR: return "surface lost";
    case VK_ERROR_NATIVE_WINDOW_IN_USE_KHR: return "window already in use";
    case VK_ERROR_OUT_OF_DATE_KHR: return "surface out of date";
    default: return "unknown error";
  }
}

}  // namespace

void must(VkResult result, const char* what) {
  if (result >= 0) return;
  throw DeviceError(std::string("Vulkan: ") + what + ": " + name_of(result) + " (" + std::to_string(result) + ")");
}

}  // namespace sinew::viewer
