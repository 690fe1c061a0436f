// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include <vulkan/vulkan.h>

struct GLFWwindow;

namespace sinew::viewer {

class Device;
class Swapchain;

/// Dear ImGui with its GLFW and Vulkan backends. Receives the window's input and draws over a finished picture.
/// thread: the window's thread;   only one object may exist at a time
class PanelBackend {
 public:
  PanelBackend(Device& device, const Swapchain& swapchain, GLFWwindow* window);
  ~PanelBackend();  ///< waits for the device
  PanelBackend(const PanelBackend&) = delete;
  PanelBackend& operator=(const PanelBackend&) = delete;

  /// Recreates the framebuffers for the new images after Swapchain::remake.
  void follow(const Swapchain& swapchain);

  /// Begins an ImGui frame. Lay out the panel with ImGui calls between begin() and record().
  void begin();

  /// Ends the ImGui frame and draws it over the image.
  /// in   image  in layout COLOR_ATTACHMENT_OPTIMAL; left in PRESENT_SRC
  void record(VkCommandBuffer commands, std::uint32_t image);

  bool wants_mouse() const;  ///< true if the mouse is over the panel or a drag began there
  bool wants_keys() const;   ///< true while text is typed into the panel

 private:
  void make_render_pass(VkFormat format);
  void destroy_framebuffers() noexcept;

  Device& device_;
  VkRenderPass render_pass_ = VK_NULL_HANDLE;
  VkDescriptorPool descriptors_ = VK_NULL_HANDLE;
  std::vector<VkFramebuffer> framebuffers_;
  VkExtent2D extent_{};
};

}  // namespace sinew::viewer
