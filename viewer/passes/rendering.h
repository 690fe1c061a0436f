// SPDX-License-Identifier: MIT
#pragma once
#include "viewer/passes/frame_targets.h"

namespace sinew::viewer {

/// The attachments of a pass.
struct Attachments {
  VkImageView color = VK_NULL_HANDLE;
  VkAttachmentLoadOp load = VK_ATTACHMENT_LOAD_OP_DONT_CARE;             ///< CLEAR = to zeros
  VkImageView resolve = VK_NULL_HANDLE;                                  ///< gets the mean of the samples of `color`
  VkImageView second = VK_NULL_HANDLE, second_resolve = VK_NULL_HANDLE;  ///< as `color` and `resolve`; null = none
  VkImageView third = VK_NULL_HANDLE, third_resolve = VK_NULL_HANDLE;
  VkImageView depth = VK_NULL_HANDLE;
  bool depth_write = false;  ///< true: depth is cleared and written; false: it is loaded and only tested
  VkExtent2D extent{};
};

/// Dynamic rendering: begins on construction and ends with the object.
class Rendering {
 public:
  Rendering(VkCommandBuffer commands, const Attachments& attachments);
  ~Rendering() { vkCmdEndRendering(commands_); }
  Rendering(const Rendering&) = delete;
  Rendering& operator=(const Rendering&) = delete;

 private:
  VkCommandBuffer commands_;
};

/// Draws go to this part of the attachments, which at first is all of them.
void set_area(VkCommandBuffer commands, const VkRect2D& area);

}  // namespace sinew::viewer
