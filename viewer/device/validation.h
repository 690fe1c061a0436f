// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "viewer/device/device_error.h"

namespace sinew::viewer {

bool validation_installed();

/// Enables validation with synchronisation checks on an instance, and delivers its messages.
class ValidationRequest {
 public:
  ValidationRequest(PFN_vkDebugUtilsMessengerCallbackEXT callback, void* user);

  /// Adds the layer to `info` and its extension to `extensions`. This object must live until the instance is created.
  void add_to(VkInstanceCreateInfo& info, std::vector<const char*>& extensions);
  VkDebugUtilsMessengerEXT create_messenger(VkInstance instance) const;

 private:
  VkDebugUtilsMessengerCreateInfoEXT messenger_{VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT};
  VkValidationFeaturesEXT features_{VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT};
};

void destroy_messenger(VkInstance instance, VkDebugUtilsMessengerEXT messenger) noexcept;

}  // namespace sinew::viewer
