// SPDX-License-Identifier: MIT
#include "viewer/app/window.h"

#include <utility>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <glm/common.hpp>

#include "viewer/device/device_error.h"

namespace sinew::viewer {
namespace {

constexpr const char* kWithoutWindow = "; pictures can be made without a window: --headless OUT.png";

std::string last_complaint() {
  const char* text = nullptr;
  glfwGetError(&text);
  return text ? text : "no reason given";
}

Window& of(GLFWwindow* window) { return *static_cast<Window*>(glfwGetWindowUserPointer(window)); }

}  // namespace

Window::Window(std::uint32_t width, std::uint32_t height, const std::string& title) {
  if (!glfwInit()) throw DeviceError("no display for a window (" + last_complaint() + ")" + kWithoutWindow);
  glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
  window_ = glfwCreateWindow(static_cast<int>(width), static_cast<int>(height), title.c_str(), nullptr, nullptr);
  if (!window_) {
    const std::string why = last_complaint();
    glfwTerminate();
    throw DeviceError("the window cannot be opened (" + why + ")" + kWithoutWindow);
  }
  glfwSetWindowSizeLimits(window_, 160, 120, GLFW_DONT_CARE, GLFW_DONT_CARE);
  listen();
  glfwGetCursorPos(window_, &mouse_.x, &mouse_.y);
}

void Window::listen() {
  glfwSetWindowUserPointer(window_, this);
  glfwSetKeyCallback(window_, [](GLFWwindow* w, int key, int, int action, int) {
    of(w).input_.any = true;
    if (action != GLFW_RELEASE) of(w).input_.keys.push_back(key);
  });
  glfwSetScrollCallback(window_, [](GLFWwindow* w, double, double y) {
    of(w).input_.any = true;
    of(w).input_.wheel += y;
  });
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* w, int button, int action, int mods) {
    of(w).input_.any = true;
    if (button == GLFW_MOUSE_BUTTON_LEFT) of(w).press_left(action == GLFW_PRESS, (mods & GLFW_MOD_SHIFT) != 0);
  });
  glfwSetCursorPosCallback(window_, [](GLFWwindow* w, double x, double y) { of(w).move_mouse({x, y}); });
  glfwSetDropCallback(window_, [](GLFWwindow* w, int count, const char** paths) {
    of(w).input_.any = true;
    of(w).input_.dropped.insert(of(w).input_.dropped.end(), paths, paths + count);
  });
  glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* w, int, int) { of(w).input_.any = true; });
  glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { of(w).input_.any = true; });
  glfwSetWindowFocusCallback(window_, [](GLFWwindow* w, int) { of(w).input_.any = true; });
}

// Attributes this mouse movement to the buttons held now. GLFW delivers events in order, so a press and a release
// between two polls still drag over the right distance.
void Window::move_mouse(const glm::dvec2& to) {
  const auto held = [&](int button) { return glfwGetMouseButton(window_, button) == GLFW_PRESS; };
  const bool shift =
      glfwGetKey(window_, GLFW_KEY_LEFT_SHIFT) == GLFW_PRESS || glfwGetKey(window_, GLFW_KEY_RIGHT_SHIFT) == GLFW_PRESS;
  const bool left = held(GLFW_MOUSE_BUTTON_LEFT);
  const bool moves = held(GLFW_MOUSE_BUTTON_RIGHT) || held(GLFW_MOUSE_BUTTON_MIDDLE) || (left && shift);
  glm::ivec2 size(0), pixels(0);
  glfwGetWindowSize(window_, &size.x, &size.y);
  glfwGetFramebufferSize(window_, &pixels.x, &pixels.y);
  const glm::dvec2 way =
      size.x > 0 && size.y > 0 ? (to - mouse_) * glm::dvec2(pixels) / glm::dvec2(size) : glm::dvec2(0.0);
  if (moves)
    input_.moved += way;
  else if (left)
    input_.turned += way;
  input_.any = true;
  mouse_ = to;
}

// A click is a press and a release without a drag in between.
void Window::press_left(bool down, bool shift) {
  constexpr double kStill_px = 4.0;
  if (down) {
    pressed_at_ = mouse_;
    return;
  }
  const glm::dvec2 way = glm::abs(mouse_ - pressed_at_);
  if (shift || way.x > kStill_px || way.y > kStill_px) return;
  glm::ivec2 size(0);
  glfwGetWindowSize(window_, &size.x, &size.y);
  if (size.x > 0 && size.y > 0)
    input_.clicked = glm::dvec2(2.0 * mouse_.x / size.x - 1.0, 1.0 - 2.0 * mouse_.y / size.y);
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
  return std::exchange(input_, {});
}

}  // namespace sinew::viewer
