// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "viewer/app/live_plan.h"
#include "viewer/app/panel/panel_backend.h"
#include "viewer/app/settings.h"
#include "viewer/app/shown_scene.h"
#include "viewer/device/swapchain.h"
#include "viewer/passes/frame_renderer.h"

namespace sinew::viewer {

/// Draws the frames of the window. frame.cpp shows a whole frame, from the newest pose to presentation. Two frames are
/// in flight: the CPU fills one while the GPU draws the other.
class Frame {
 public:
  static constexpr std::uint32_t kSlots = 2;

  Frame(Device& device, Swapchain& swapchain, PanelBackend& panel);
  ~Frame();  ///< waits until the device is idle
  Frame(const Frame&) = delete;
  Frame& operator=(const Frame&) = delete;

  /// Draws and presents one picture: the scene, skeleton lines over it, and the panel on top.
  /// in   lay_out  called once to lay out the panel with ImGui
  /// out  false if no swapchain image was available; nothing was drawn then
  bool draw(ShownScene& shown, const View& view, const RenderOptions& options, const Settings& settings,
            const std::function<void()>& lay_out);

  /// GPU pass times of the picture kSlots frames ago, the newest one that the GPU has certainly finished.
  std::span<const PassTime> pass_times();

  /// Times of the last picture besides drawing the scene.
  const WindowTimes& window_times() const noexcept { return window_times_; }

  /// Statistics of the last picture.
  const FrameReport& report() const noexcept { return report_; }

 private:
  struct Slot {
    VkCommandPool pool = VK_NULL_HANDLE;
    VkCommandBuffer commands = VK_NULL_HANDLE;
    VkFence done = VK_NULL_HANDLE;
    VkSemaphore image_ready = VK_NULL_HANDLE;
  };
  void begin(const Slot& slot) const;
  void submit(const Slot& slot, std::uint32_t image) const;

  Device& device_;
  Swapchain& swapchain_;
  PanelBackend& panel_;
  FrameRenderer renderer_;
  Slot slots_[kSlots];
  std::uint32_t next_ = 0;
  std::vector<PassTime> pass_times_;
  FrameReport report_;
  WindowTimes window_times_;
};

}  // namespace sinew::viewer
