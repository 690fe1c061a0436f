// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include <vulkan/vulkan.h>
#include <glm/vec2.hpp>

struct GLFWwindow;

namespace sinew::viewer {

/// User input since the last poll.
struct Input {
  std::vector<int> keys;  ///< pressed or repeated keys, as key codes of keys.h
  /// Drag distances in framebuffer pixels, y down. `turned`: with the left button. `moved`: with the right or middle
  /// button, or with shift and the left button.
  glm::dvec2 turned{0.0}, moved{0.0};
  std::optional<glm::dvec2> clicked;  ///< place of a left click without a drag: -1 to 1, y up
  double wheel = 0.0;
  std::vector<std::string> dropped;  ///< paths of files and folders that were dropped on the window
  bool any = false;                  ///< true if any event arrived, even one that is not listed above
};

/// A desktop window. It cannot be moved in memory, because GLFW callbacks hold its address. Only window.cpp and
/// panel_backend.cpp use GLFW.
class Window {
 public:
  /// err  DeviceError if there is no display, or no Vulkan driver for it
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

  /// Processes pending desktop events. Waits up to `wait_s` for the first one (0 = does not wait).
  Input poll(double wait_s);

  GLFWwindow* handle() const noexcept { return window_; }

 private:
  void listen();
  void move_mouse(const glm::dvec2& to);
  void press_left(bool down, bool shift);

  GLFWwindow* window_ = nullptr;
  Input input_;  ///< collected since the last poll
  glm::dvec2 mouse_{0.0}, pressed_at_{0.0};
};

}  // namespace sinew::viewer
