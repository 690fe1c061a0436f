// SPDX-License-Identifier: MIT
#pragma once
#include <stdexcept>
#include <string>

#include <vulkan/vulkan.h>

namespace sinew::viewer {

/// A failure of the machine: no Vulkan device, out of memory, device lost. Programs print the message and exit with
/// code 3. It is the only exception type that the viewer throws.
class DeviceError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Throws DeviceError with `what` and the name of the result code if a call failed. Positive codes, such as
/// VK_SUBOPTIMAL_KHR, are not failures.
void must(VkResult result, const char* what);

}  // namespace sinew::viewer
