// SPDX-License-Identifier: MIT
#include "viewer/device/validation.h"

#include <algorithm>
#include <string_view>

#include "viewer/device/listed.h"

namespace sinew::viewer {

namespace {

constexpr const char* kLayer = "VK_LAYER_KHRONOS_validation";
constexpr VkValidationFeatureEnableEXT kSynchronisation = VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT;

}  // namespace

bool validation_installed() {
  const auto layers =
      listed<VkLayerProperties>("vkEnumerateInstanceLayerProperties", vkEnumerateInstanceLayerProperties);
  return std::any_of(layers.begin(), layers.end(),
                     [](const VkLayerProperties& layer) { return std::string_view(layer.layerName) == kLayer; });
}

ValidationRequest::ValidationRequest(PFN_vkDebugUtilsMessengerCallbackEXT callback, void* user) {
  messenger_.messageSeverity =
      VK_DEBUG_UTILS_MESSAGE_SEVERITY_WARNING_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_SEVERITY_ERROR_BIT_EXT;
  messenger_.messageType =
      VK_DEBUG_UTILS_MESSAGE_TYPE_VALIDATION_BIT_EXT | VK_DEBUG_UTILS_MESSAGE_TYPE_PERFORMANCE_BIT_EXT;
  messenger_.pfnUserCallback = callback;
  messenger_.pUserData = user;
  features_.enabledValidationFeatureCount = 1;
  features_.pEnabledValidationFeatures = &kSynchronisation;
}

void ValidationRequest::add_to(VkInstanceCreateInfo& info, std::vector<const char*>& extensions) {
  extensions.push_back(VK_EXT_DEBUG_UTILS_EXTENSION_NAME);
  features_.pNext = info.pNext;
  info.pNext = &features_;
  info.enabledLayerCount = 1;
  info.ppEnabledLayerNames = &kLayer;
}

VkDebugUtilsMessengerEXT ValidationRequest::create_messenger(VkInstance instance) const {
  const auto create = reinterpret_cast<PFN_vkCreateDebugUtilsMessengerEXT>(
      vkGetInstanceProcAddr(instance, "vkCreateDebugUtilsMessengerEXT"));
  if (!create) throw DeviceError("Vulkan: the validation layer lacks VK_EXT_debug_utils");
  VkDebugUtilsMessengerEXT messenger = VK_NULL_HANDLE;
  must(create(instance, &messenger_, nullptr, &messenger), "vkCreateDebugUtilsMessengerEXT");
  return messenger;
}

void destroy_messenger(VkInstance instance, VkDebugUtilsMessengerEXT messenger) noexcept {
  const auto destroy = reinterpret_cast<PFN_vkDestroyDebugUtilsMessengerEXT>(
      vkGetInstanceProcAddr(instance, "vkDestroyDebugUtilsMessengerEXT"));
  if (destroy) destroy(instance, messenger, nullptr);
}

}  // namespace sinew::viewer
