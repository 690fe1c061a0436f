// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "viewer/device/device.h"

namespace sinew::viewer {

/// The images of a window's surface. Survives resizing and minimising: a surface without area has no images, and
/// acquire() then gives none. Presents in FIFO order, which every device has.
class Swapchain {
 public:
  /// in   size  of the window's framebuffer in pixels; used where the surface does not say its own size
  Swapchain(Device& device, VkExtent2D size);
  ~Swapchain();  ///< waits until the device is idle
  Swapchain(const Swapchain&) = delete;
  Swapchain& operator=(const Swapchain&) = delete;

  /// Makes the images again for the surface as it is now; waits until the device is idle.
  void remake(VkExtent2D size);

  /// The next image to draw to. Nothing when the surface has no area, no longer fits (fits() then says so), or shows
  /// nothing at the moment, so that no image came back within a tenth of a second.
  /// `ready` is signalled once the image may be written; untouched when there is none.
  std::optional<std::uint32_t> acquire(VkSemaphore ready);

  /// Shows the image after `drawn(image)` is signalled.
  void present(std::uint32_t image);

  /// The images are for a surface of this size that has not changed since; otherwise remake().
  bool fits(VkExtent2D size) const noexcept {
    return !stale_ && size.width == asked_.width && size.height == asked_.height;
  }

  /// 8 bits a channel without hardware sRGB encoding, so that shaders write encoded values; the same for all remakes.
  VkFormat format() const noexcept { return format_.format; }
  VkExtent2D extent() const noexcept { return extent_; }
  std::uint32_t image_count() const noexcept { return static_cast<std::uint32_t>(images_.size()); }
  VkImage image(std::uint32_t i) const noexcept { return images_[i]; }
  VkImageView view(std::uint32_t i) const noexcept { return views_[i]; }

  /// To be signalled by the submit that draws to the image. One per image: it is free again when the image is acquired.
  VkSemaphore drawn(std::uint32_t i) const noexcept { return drawn_[i]; }

 private:
  void make(VkExtent2D size, VkSwapchainKHR old);
  void destroy_views() noexcept;

  Device& device_;
  VkSwapchainKHR swapchain_ = VK_NULL_HANDLE;
  VkSurfaceFormatKHR format_{};
  VkExtent2D extent_{}, asked_{};
  std::vector<VkImage> images_;
  std::vector<VkImageView> views_;
  std::vector<VkSemaphore> drawn_;
  bool stale_ = false;
};

}  // namespace sinew::viewer
