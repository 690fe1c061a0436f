// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include <vulkan/vulkan.h>

struct GLFWwindow;

namespace sinew::viewer {

class Device;
class Swapchain;

/// Dear ImGui with its GLFW and Vulkan parts: takes input of the window, draws over a finished picture.
/// thread: the window's;   one at a time
class PanelBackend {
 public:
  PanelBackend(Device& device, const Swapchain& swapchain, GLFWwindow* window);
  ~PanelBackend();  ///< the GPU must be done with all frames
  PanelBackend(const PanelBackend&) = delete;
  PanelBackend& operator=(const PanelBackend&) = delete;

  /// Call after Swapchain::remake.
  void follow(const Swapchain& swapchain);

  /// Between begin() and record() the panel is laid out with ImGui calls.
  void begin();

  /// Finishes the layout and draws it over the image, which must be in COLOR_ATTACHMENT_OPTIMAL and is left ready for
  /// presenting.
  void record(VkCommandBuffer commands, std::uint32_t image);

  bool wants_mouse() const;  ///< the mouse is over the panel, or a drag began there
  bool wants_keys() const;   ///< text is being typed

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
