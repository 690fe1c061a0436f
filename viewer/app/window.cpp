// SPDX-License-Identifier: MIT
#include "viewer/app/window.h"

#include <utility>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "viewer/device/device_error.h"

namespace sinew::viewer {
namespace {

constexpr const char* kWithoutWindow = "; pictures can be made without a window: --headless OUT.png";

std::string last_complaint() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text ? text : "no reason given";
}

Input& input_of(GLFWwindow* window) { return *static_cast<Input*>(glfwGetWindowUserPointer(window)); }

void listen(GLFWwindow* window) {
  glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int) {
    input_of(w).any = true;
    if (action != GLFW_RELEASE) input_of(w).keys.push_back(key);
  });
  glfwSetScrollCallback(window, [](GLFWwindow* w, double, double y) {
    input_of(w).any = true;
    input_of(w).wheel += y;
  });
  glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int, int, int) { input_of(w).any = true; });
  glfwSetCursorPosCallback(window, [](GLFWwindow* w, double, double) { input_of(w).any = true; });
  glfwSetFramebufferSizeCallback(window, [](GLFWwindow* w, int, int) { input_of(w).any = true; });
  glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { input_of(w).any = true; });
  glfwSetWindowFocusCallback(window, [](GLFWwindow* w, int) { input_of(w).any = true; });
}

}  // namespace

Window::Window(std::uint32_t width, std::uint32_t height, const std::string& title)
    : input_(std::make_unique<Input>()) {
  if (!glfwInit()) throw DeviceError("no display for a window (" + last_complaint() + ")" + kWithoutWindow);
  glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
  window_ = glfwCreateWindow(static_cast<int>(width), static_cast<int>(height), title.c_str(), nullptr, nullptr);
  if (!window_) {
    const std::string why = last_complaint();
    glfwTerminate();
    throw DeviceError("the window cannot be opened (" + why + ")" + kWithoutWindow);
  }
  glfwSetWindowSizeLimits(window_, 160, 120, GLFW_DONT_CARE, GLFW_DONT_CARE);
  glfwSetWindowUserPointer(window_, input_.get());
  listen(window_);
  glfwGetCursorPos(window_, &mouse_x_, &mouse_y_);
}

Window::~Window() {
  glfwDestroyWindow(window_);
  glfwTerminate();
}

std::vector<const char*> Window::instance_extensions() const {
  std::uint32_t count = 0;
  const char** names = glfwGetRequiredInstanceExtensions(&count);
  if (!names)
    throw DeviceError(
        std::string("no Vulkan driver for this display was found (Debian: mesa-vulkan-drivers has one for every "
                    "machine)") +
        kWithoutWindow);
  return {names, names + count};
}

VkSurfaceKHR Window::make_surface(VkInstance instance) const {
  VkSurfaceKHR surface = VK_NULL_HANDLE;
  must(glfwCreateWindowSurface(instance, window_, nullptr, &surface), "making the window's surface");
  return surface;
}

VkExtent2D Window::framebuffer_size() const {
  int width = 0, height = 0;
  glfwGetFramebufferSize(window_, &width, &height);
  if (glfwGetWindowAttrib(window_, GLFW_ICONIFIED)) return {0, 0};
  return {static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height)};
}

bool Window::should_close() const { return glfwWindowShouldClose(window_) != 0; }

void Window::close() { glfwSetWindowShouldClose(window_, GLFW_TRUE); }

void Window::set_title(const std::string& title) { glfwSetWindowTitle(window_, title.c_str()); }

Input Window::poll(double wait_s) {
  if (wait_s > 0.0)
    glfwWaitEventsTimeout(wait_s);
  else
    glfwPollEvents();
  Input seen = std::exchange(*input_, {});
  const auto held = [&](int button) { return glfwGetMouseButton(window_, button) == GLFW_PRESS; };
  const bool shift =
      glfwGetKey(window_, GLFW_KEY_LEFT_SHIFT) == GLFW_PRESS || glfwGetKey(window_, GLFW_KEY_RIGHT_SHIFT) == GLFW_PRESS;
  const bool left = held(GLFW_MOUSE_BUTTON_LEFT);
  seen.move_held = held(GLFW_MOUSE_BUTTON_RIGHT) || held(GLFW_MOUSE_BUTTON_MIDDLE) || (left && shift);
  seen.turn_held = left && !seen.move_held;

  double x = 0.0, y = 0.0;
  int width = 1, height = 1, pixels_wide = 1, pixels_high = 1;
  glfwGetCursorPos(window_, &x, &y);
  glfwGetWindowSize(window_, &width, &height);
  glfwGetFramebufferSize(window_, &pixels_wide, &pixels_high);
  if (width > 0 && height > 0) {
    seen.moved_x = (x - mouse_x_) * pixels_wide / width;
    seen.moved_y = (y - mouse_y_) * pixels_high / height;
  }
  mouse_x_ = x;
  mouse_y_ = y;
  return seen;
}

}  // namespace sinew::viewer
