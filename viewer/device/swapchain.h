// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "viewer/device/device.h"

namespace sinew::viewer {

/// The images of a window's surface. While the surface has no area (a minimised window), there are no images and
/// acquire() returns nothing. Uses FIFO presentation, which every device supports.
class Swapchain {
 public:
  /// in   size  of the window's framebuffer in pixels; used if the surface does not define its own size
  Swapchain(Device& device, VkExtent2D size);
  ~Swapchain();  ///< waits until the device is idle
  Swapchain(const Swapchain&) = delete;
  Swapchain& operator=(const Swapchain&) = delete;

  /// Recreates the images for the current surface; waits until the device is idle.
  void remake(VkExtent2D size);

  /// The index of the next image to draw to. Empty if the surface has no area, if the images no longer fit it (then
  /// fits() is false), or if no image became available within 0.1 s.
  /// in   ready  signalled when the image may be written; not signalled if no image is returned
  std::optional<std::uint32_t> acquire(VkSemaphore ready);

  /// Presents the image once `drawn(image)` is signalled.
  void present(std::uint32_t image);

  /// True if the images have this size and the surface has not changed. Otherwise call remake().
  bool fits(VkExtent2D size) const noexcept {
    return !stale_ && size.width == requested_size_.width && size.height == requested_size_.height;
  }

  /// 8 bits per channel without hardware sRGB encoding: shaders write encoded values. Constant over the object's life.
  VkFormat format() const noexcept { return format_.format; }
  VkExtent2D extent() const noexcept { return extent_; }
  std::uint32_t image_count() const noexcept { return static_cast<std::uint32_t>(images_.size()); }
  VkImage image(std::uint32_t i) const noexcept { return images_[i]; }
  VkImageView view(std::uint32_t i) const noexcept { return views_[i]; }

  /// Semaphore that the submit that draws the image must signal. There is one per image; it can be reused once the
  /// image is acquired again.
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
