// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "viewer/device/device_error.h"

namespace sinew::viewer {

bool validation_installed();

/// Enables the validation layer, with synchronisation checks, for an instance and its message callback.
class ValidationRequest {
 public:
  ValidationRequest(PFN_vkDebugUtilsMessengerCallbackEXT callback, void* user);

  /// Adds the layer to `info` and its extension to `extensions`. `info` points into this object afterwards.
  void add_to(VkInstanceCreateInfo& info, std::vector<const char*>& extensions);
  VkDebugUtilsMessengerEXT create_messenger(VkInstance instance) const;

 private:
  VkDebugUtilsMessengerCreateInfoEXT messenger_{VK_STRUCTURE_TYPE_DEBUG_UTILS_MESSENGER_CREATE_INFO_EXT};
  VkValidationFeaturesEXT features_{VK_STRUCTURE_TYPE_VALIDATION_FEATURES_EXT};
};

void destroy_messenger(VkInstance instance, VkDebugUtilsMessengerEXT messenger) noexcept;

}  // namespace sinew::viewer
