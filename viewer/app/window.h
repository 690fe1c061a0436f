// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include <vulkan/vulkan.h>
#include <glm/vec2.hpp>

struct GLFWwindow;

namespace sinew::viewer {

/// What the user did since the last poll.
struct Input {
  std::vector<int> keys;  ///< pressed or repeated, key codes of keys.h
  /// Ways of the mouse, framebuffer pixels, y down: with the left button, and with the right or middle one or shift and
  /// left.
  glm::dvec2 turned{0.0}, moved{0.0};
  double wheel = 0.0;
  bool any = false;  ///< some event arrived, possibly none of the above
};

/// A window of the desktop, which stays where it is in memory. Only window.cpp and panel_backend.cpp know GLFW.
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
  void listen();
  void move_mouse(const glm::dvec2& to);

  GLFWwindow* window_ = nullptr;
  Input input_;  ///< since the last poll
  glm::dvec2 mouse_{0.0};
};

}  // namespace sinew::viewer
