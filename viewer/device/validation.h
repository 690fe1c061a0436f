// SPDX-License-Identifier: MIT
#pragma once
#include <string_view>
#include <vector>

#include "viewer/device/device_error.h"

namespace sinew::viewer {

bool validation_installed();

/// Messages that report nothing wrong. One is known: the layer warns about `Invariant` on members of gl_PerVertex,
/// which GLSL compilers write for `invariant gl_Position`; the depth prepass needs it.
bool is_known_false_alarm(std::string_view message) noexcept;

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
