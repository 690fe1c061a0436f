// SPDX-License-Identifier: MIT
#pragma once
#include "viewer/device/device.h"

namespace sinew::viewer {

/// Copies a whole image in layout TRANSFER_SRC_OPTIMAL to a buffer, rows tight from the top, and makes it visible to
/// the CPU once the commands are done.
void read_back(VkCommandBuffer commands, VkImage image, VkExtent2D extent, VkBuffer to);

}  // namespace sinew::viewer
