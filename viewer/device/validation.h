// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "viewer/device/device_error.h"

namespace sinew::viewer {

bool validation_installed();

/// Asks an instance for validation with synchronisation checks and for its messages.
class ValidationRequest {
 public:
  ValidationRequest(PFN_vkDebugUtilsMessengerCallbackEXT callback, void* user);

  /// Extends `info` and `extensions`; this object must live until the instance is created.
  void add_to(VkInstanceCreateInfo& info, std::vector<const char*>& extensions);
  VkDebugUtilsMessengerEXT create_messenger(VkInstance instance) const;

 private:
  VkDebugUtilsMessengerCreateInfoEXT messenger_{VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT};
  VkValidationFeaturesEXT features_{VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT};
};

void destroy_messenger(VkInstance instance, VkDebugUtilsMessengerEXT messenger) noexcept;

}  // namespace sinew::viewer
