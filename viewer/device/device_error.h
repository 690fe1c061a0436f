// SPDX-License-Identifier: MIT
#pragma once
#include <stdexcept>
#include <string>

#include <vulkan/vulkan.h>

namespace sinew::viewer {

/// The machine lacks something or gave up: no Vulkan device, out of memory, device lost. Programs print the message and
/// exit with code 3. The only exception that the viewer throws.
class DeviceError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Throws DeviceError naming `what` and the code unless the call succeeded. VK_SUBOPTIMAL_KHR and other positive codes
/// pass.
void must(VkResult result, const char* what);

}  // namespace sinew::viewer
