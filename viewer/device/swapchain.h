// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "viewer/device/device.h"

namespace sinew::viewer {

/// The images of a window's surface. A surface without area (a minimised window) has no images, and acquire() then
/// returns none. Presents in FIFO mode, which every device has.
class Swapchain {
 public:
  /// in   size  of the window's framebuffer, pixels; used if the surface does not state its size
  Swapchain(Device& device, VkExtent2D size);
  ~Swapchain();  ///< waits until the device is idle
  Swapchain(const Swapchain&) = delete;
  Swapchain& operator=(const Swapchain&) = delete;

  /// Creates the images again for the present surface; waits until the device is idle.
  void remake(VkExtent2D size);

  /// The index of the next image to draw to. Nothing when the surface has no area, when the images no longer fit it
  /// (fits() is then false), or when none was free within a tenth of a second.
  /// in   ready  signalled once the image may be written; not signalled when there is no image
  std::optional<std::uint32_t> acquire(VkSemaphore ready);

  /// Shows the image after `drawn(image)` is signalled.
  void present(std::uint32_t image);

  /// The images have this size and the surface has not changed; otherwise call remake().
  bool fits(VkExtent2D size) const noexcept {
    return !stale_ && size.width == requested_size_.width && size.height == requested_size_.height;
  }

  /// 8 bits a channel without hardware sRGB encoding: shaders write encoded values. It never changes.
  VkFormat format() const noexcept { return format_.format; }
  VkExtent2D extent() const noexcept { return extent_; }
  std::uint32_t image_count() const noexcept { return static_cast<std::uint32_t>(images_.size()); }
  VkImage image(std::uint32_t i) const noexcept { return images_[i]; }
  VkImageView view(std::uint32_t i) const noexcept { return views_[i]; }

  /// Semaphore that the submit which draws the image must signal. One per image: it is free again once the image is
  /// acquired.
  VkSemaphore drawn(std::uint32_t i) const noexcept { return drawn_[i]; }

 private:
  void make(VkExtent2D size, VkSwapchainKHR old);
  void destroy_views() noexcept;

  Device& device_;
  VkSwapchainKHR swapchain_ = VK_NULL_HANDLE;
  VkSurfaceFormatKHR format_{};
  VkExtent2D extent_{}, requested_size_{};
  std::vector<VkImage> images_;
  std::vector<VkImageView> views_;
  std::vector<VkSemaphore> drawn_;
  bool stale_ = false;
};

}  // namespace sinew::viewer
