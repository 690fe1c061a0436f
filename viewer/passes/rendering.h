// SPDX-License-Identifier: MIT
#pragma once
#include "viewer/passes/frame_targets.h"

namespace sinew::viewer {

/// The attachments of a render pass.
struct Attachments {
  VkImageView color = VK_NULL_HANDLE;
  VkAttachmentLoadOp load = VK_ATTACHMENT_LOAD_OP_DONT_CARE;  ///< CLEAR clears to `clear`
  VkImageView resolve = VK_NULL_HANDLE;                       ///< receives the resolved samples of `color`
  /// Second attachment and its resolve image; null = none.
  VkImageView second = VK_NULL_HANDLE, second_resolve = VK_NULL_HANDLE;
  VkImageView third = VK_NULL_HANDLE, third_resolve = VK_NULL_HANDLE;
  VkImageView depth = VK_NULL_HANDLE;
  bool depth_write = false;  ///< true = depth is cleared and written; false = loaded and only tested
  VkClearColorValue clear{};
  VkExtent2D extent{};
  VkRect2D within{};  ///< only this part is cleared, drawn and resolved; empty = everything
};

/// Begins dynamic rendering on construction and ends it on destruction.
class Rendering {
 public:
  Rendering(VkCommandBuffer commands, const Attachments& attachments);
  ~Rendering() { vkCmdEndRendering(commands_); }
  Rendering(const Rendering&) = delete;
  Rendering& operator=(const Rendering&) = delete;

 private:
  VkCommandBuffer commands_;
};

/// Restricts viewport and scissor to this rectangle. Initially they cover the whole attachments.
void set_area(VkCommandBuffer commands, const VkRect2D& area);

}  // namespace sinew::viewer
