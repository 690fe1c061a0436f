// SPDX-License-Identifier: MIT
#include "viewer/device/swapchain.h"

#include <algorithm>

#include "viewer/device/listed.h"

namespace sinew::viewer {
namespace {

// Because images of a hidden window may never become available.
constexpr std::uint64_t kAcquireTimeout_ns = 100'000'000;

VkSurfaceFormatKHR choose_format(const Device& device) {
  const auto formats =
      listed<VkSurfaceFormatKHR>("listing surface formats", [&](std::uint32_t* count, VkSurfaceFormatKHR* entries) {
        return vkGetPhysicalDeviceSurfaceFormatsKHR(device.physical(), device.surface(), count, entries);
      });
  for (const VkFormat wanted : {VK_FORMAT_B8G8R8A8_UNORM, VK_FORMAT_R8G8B8A8_UNORM, VK_FORMAT_A8B8G8R8_UNORM_PACK32})
    for (const auto& format : formats)
      if (format.format == wanted && format.colorSpace == VK_COLOR_SPACE_SRGB_NONLINEAR_KHR) return format;
  throw DeviceError("the window's surface offers no 8-bit UNORM format");
}

VkExtent2D choose_extent(const VkSurfaceCapabilitiesKHR& surface, VkExtent2D size) {
  if (surface.currentExtent.width != 0xffffffffu) return surface.currentExtent;
  return {std::clamp(size.width, surface.minImageExtent.width, surface.maxImageExtent.width),
          std::clamp(size.height, surface.minImageExtent.height, surface.maxImageExtent.height)};
}

}  // namespace

Swapchain::Swapchain(Device& device, VkExtent2D size) : device_(device), format_(choose_format(device)) {
  make(size, VK_NULL_HANDLE);
}

Swapchain::~Swapchain() {
  vkDeviceWaitIdle(device_.handle());
  destroy_views();
  vkDestroySwapchainKHR(device_.handle(), swapchain_, nullptr);
}

void Swapchain::remake(VkExtent2D size) {
  device_.wait_idle();
  destroy_views();
  const VkSwapchainKHR old = swapchain_;
  swapchain_ = VK_NULL_HANDLE;
  make(size, old);
  vkDestroySwapchainKHR(device_.handle(), old, nullptr);
}

void Swapchain::make(VkExtent2D size, VkSwapchainKHR old) {
  stale_ = false;
  requested_size_ = size;
  VkSurfaceCapabilitiesKHR surface{};
  must(vkGetPhysicalDeviceSurfaceCapabilitiesKHR(device_.physical(), device_.surface(), &surface),
       "asking the surface");
  extent_ = size.width == 0 || size.height == 0 ? VkExtent2D{} : choose_extent(surface, size);
  if (extent_.width == 0 || extent_.height == 0) return;  // minimised

  VkSwapchainCreateInfoKHR info{VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR};
  info.surface = device_.surface();
  info.minImageCount = surface.minImageCount + 1;
  if (surface.maxImageCount != 0) info.minImageCount = std::min(info.minImageCount, surface.maxImageCount);
  info.imageFormat = format_.format;
  info.imageColorSpace = format_.colorSpace;
  info.imageExtent = extent_;
  info.imageArrayLayers = 1;
  info.imageUsage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
  info.preTransform = surface.currentTransform;
  info.compositeAlpha = surface.supportedCompositeAlpha & VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR
                            ? VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR
                            : VK_COMPOSITE_ALPHA_INHERIT_BIT_KHR;
  info.presentMode = VK_PRESENT_MODE_FIFO_KHR;
  info.clipped = VK_TRUE;
  info.oldSwapchain = old;
  must(vkCreateSwapchainKHR(device_.handle(), &info, nullptr, &swapchain_), "making the swapchain");

  images_ = listed<VkImage>("listing swapchain images", [&](std::uint32_t* count, VkImage* images) {
    return vkGetSwapchainImagesKHR(device_.handle(), swapchain_, count, images);
  });
  for (const VkImage image : images_) {
    VkImageViewCreateInfo view{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
    view.image = image;
    view.viewType = VK_IMAGE_VIEW_TYPE_2D;
    view.format = format_.format;
    view.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    must(vkCreateImageView(device_.handle(), &view, nullptr, &views_.emplace_back()), "making a swapchain view");
    const VkSemaphoreCreateInfo semaphore{VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO};
    must(vkCreateSemaphore(device_.handle(), &semaphore, nullptr, &drawn_.emplace_back()), "making a semaphore");
  }
}

void Swapchain::destroy_views() noexcept {
  for (const VkImageView view : views_) vkDestroyImageView(device_.handle(), view, nullptr);
  for (const VkSemaphore semaphore : drawn_) vkDestroySemaphore(device_.handle(), semaphore, nullptr);
  views_.clear();
  drawn_.clear();
  images_.clear();
}

std::optional<std::uint32_t> Swapchain::acquire(VkSemaphore ready) {
  if (images_.empty()) {
    stale_ = true;
    return std::nullopt;
  }
  std::uint32_t image = 0;
  const VkResult result =
      vkAcquireNextImageKHR(device_.handle(), swapchain_, kAcquireTimeout_ns, ready, VK_NULL_HANDLE, &image);
  if (result == VK_TIMEOUT || result == VK_NOT_READY) return std::nullopt;
  if (result == VK_ERROR_OUT_OF_DATE_KHR) {
    stale_ = true;
    return std::nullopt;
  }
  must(result, "acquiring a swapchain image");
  if (result == VK_SUBOPTIMAL_KHR) stale_ = true;  // this image can still be drawn and presented
  return image;
}

void Swapchain::present(std::uint32_t image) {
  VkPresentInfoKHR info{VK_STRUCTURE_TYPE_PRESENT_INFO_KHR};
  info.waitSemaphoreCount = 1;
  info.pWaitSemaphores = &drawn_[image];
  info.swapchainCount = 1;
  info.pSwapchains = &swapchain_;
  info.pImageIndices = &image;
  const VkResult result = vkQueuePresentKHR(device_.queue(), &info);
  if (result == VK_ERROR_OUT_OF_DATE_KHR || result == VK_SUBOPTIMAL_KHR)
    stale_ = true;
  else
    must(result, "showing a picture");
}

}  // namespace sinew::viewer
