// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <vulkan/vulkan.h>

struct GLFWwindow;

namespace sinew::viewer {

/// What the user did since the last poll.
struct Input {
  std::vector<int> keys;                ///< pressed or repeated, key codes of keys.h
  double moved_x = 0.0, moved_y = 0.0;  ///< of the mouse, framebuffer pixels, y down
  double wheel = 0.0;
  bool turn_held = false, move_held = false;  ///< what the held mouse buttons do
  bool any = false;                           ///< some event arrived, possibly none of the above
};

/// A window of the desktop. Only window.cpp and panel_backend.cpp know GLFW.
class Window {
 public:
  /// err  DeviceError when there is no display or the display cannot do Vulkan
  Window(std::uint32_t width, std::uint32_t height, const std::string& title);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  std::vector<const char*> instance_extensions() const;
  VkSurfaceKHR make_surface(VkInstance instance) const;

  VkExtent2D framebuffer_size() const;  ///< 0 x 0 while minimised
  bool should_close() const;
  void close();
  void set_title(const std::string& title);

  /// Handles the events of the desktop; waits up to `wait_s` for the first (0 = does not wait).
  Input poll(double wait_s);

  GLFWwindow* handle() const noexcept { return window_; }

 private:
  GLFWwindow* window_ = nullptr;
  std::unique_ptr<Input> input_;  ///< callbacks hold its address
  double mouse_x_ = 0.0, mouse_y_ = 0.0;
};

}  // namespace sinew::viewer
