// SPDX-License-Identifier: MIT
#include "viewer/device/swapchain.h"

#include <gmock/gmock.h>

#include <tuple>

#include "tests/viewer/own_driver.h"

namespace sinew::viewer {
namespace {

using testing::ElementsAre;

constexpr VkColorSpaceKHR kSrgb = VK_COLOR_SPACE_SRGB_NONLINEAR_KHR;

class swapchain : public OwnDriverTest {
 protected:
  void SetUp() override {
    OwnDriverTest::SetUp();
    own_driver().formats = {{VK_FORMAT_B8G8R8A8_UNORM, kSrgb}};
    own_driver().surface.minImageCount = 2;
    own_driver().surface.currentExtent = {320, 200};
    own_driver().surface.supportedCompositeAlpha = VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR;
    device_ = std::make_unique<Device>(DeviceOptions{.make_surface = [](VkInstance) { return own_surface(); }});
  }
  void TearDown() override {
    device_.reset();
    OwnDriverTest::TearDown();
  }
  /// The swapchain request for a window of that size.
  VkSwapchainCreateInfoKHR asked(VkExtent2D size = {320, 200}) {
    const Swapchain made(*device_, size);
    return own_driver().swapchains.back();
  }
  VkExtent2D extent(VkExtent2D size) { return Swapchain(*device_, size).extent(); }

  std::unique_ptr<Device> device_;
};

TEST_F(swapchain, has_8_bits_without_encoding_in_the_order_that_windows_like) {
  auto& formats = own_driver().formats;
  formats = {{VK_FORMAT_B8G8R8A8_SRGB, kSrgb},
             {VK_FORMAT_B8G8R8A8_UNORM, VK_COLOR_SPACE_DISPLAY_P3_NONLINEAR_EXT},
             {VK_FORMAT_A8B8G8R8_UNORM_PACK32, kSrgb}};
  EXPECT_EQ(asked().imageFormat, VK_FORMAT_A8B8G8R8_UNORM_PACK32);
  formats.push_back({VK_FORMAT_R8G8B8A8_UNORM, kSrgb});
  EXPECT_EQ(asked().imageFormat, VK_FORMAT_R8G8B8A8_UNORM);
  formats.push_back({VK_FORMAT_B8G8R8A8_UNORM, kSrgb});
  EXPECT_EQ(asked().imageFormat, VK_FORMAT_B8G8R8A8_UNORM);
  EXPECT_EQ(asked().imageColorSpace, kSrgb);
  formats.resize(2);
  EXPECT_THROW(asked(), DeviceError);
}

TEST_F(swapchain, has_the_size_of_the_surface_or_that_of_the_window_within_its_limits) {
  const auto is = [](VkExtent2D found, std::uint32_t width, std::uint32_t height) {
    EXPECT_EQ(found.width, width);
    EXPECT_EQ(found.height, height);
  };
  is(extent({640, 480}), 320, 200);
  VkSurfaceCapabilitiesKHR& surface = own_driver().surface;
  surface.currentExtent = {0xffffffffu, 0xffffffffu};
  surface.minImageExtent = {10, 20};
  surface.maxImageExtent = {1000, 2000};
  is(extent({640, 480}), 640, 480);
  is(extent({9, 9}), 10, 20);
  is(extent({5000, 5000}), 1000, 2000);
}

TEST_F(swapchain, has_an_image_more_than_the_least_where_that_many_are_allowed) {
  VkSurfaceCapabilitiesKHR& surface = own_driver().surface;
  for (const auto& [least, most, taken] :
       {std::tuple(2u, 0u, 3u), {2u, 8u, 3u}, {2u, 3u, 3u}, {2u, 2u, 2u}, {4u, 0u, 5u}}) {
    surface.minImageCount = least;
    surface.maxImageCount = most;
    const Swapchain made(*device_, {320, 200});
    EXPECT_EQ(made.image_count(), taken);
    EXPECT_NE(made.view(0), made.view(1));
    EXPECT_NE(made.image(0), made.image(1));
    EXPECT_NE(made.drawn(0), made.drawn(1));
  }
}

TEST_F(swapchain, sees_each_image_whole) {
  const Swapchain made(*device_, {320, 200});
  EXPECT_EQ(own_driver().swapchains.back().imageExtent.width, 320u);
  EXPECT_EQ(own_driver().swapchains.back().imageExtent.height, 200u);
  EXPECT_EQ(own_driver().swapchains.back().imageArrayLayers, 1u);
  ASSERT_EQ(own_driver().views.size(), 3u);
  for (std::uint32_t i = 0; i < 3; ++i) {
    const VkImageViewCreateInfo& view = own_driver().views[i];
    EXPECT_EQ(view.image, made.image(i));
    EXPECT_EQ(view.viewType, VK_IMAGE_VIEW_TYPE_2D);
    EXPECT_EQ(view.format, made.format());
    const auto& [aspect, level, levels, layer, layers] = view.subresourceRange;
    EXPECT_EQ(std::tuple(aspect, level, levels, layer, layers),
              std::tuple(VkImageAspectFlags{VK_IMAGE_ASPECT_COLOR_BIT}, 0u, 1u, 0u, 1u));
  }
}

TEST_F(swapchain, is_opaque_where_the_surface_can_be) {
  own_driver().surface.currentTransform = VK_SURFACE_TRANSFORM_ROTATE_90_BIT_KHR;
  EXPECT_EQ(asked().compositeAlpha, VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR);
  EXPECT_EQ(asked().preTransform, VK_SURFACE_TRANSFORM_ROTATE_90_BIT_KHR);
  EXPECT_EQ(asked().presentMode, VK_PRESENT_MODE_FIFO_KHR);
  EXPECT_EQ(asked().imageUsage, VkImageUsageFlags{VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT});
  EXPECT_EQ(asked().surface, device_->surface());
  EXPECT_TRUE(asked().clipped);
  own_driver().surface.supportedCompositeAlpha = VK_COMPOSITE_ALPHA_INHERIT_BIT_KHR;
  EXPECT_EQ(asked().compositeAlpha, VK_COMPOSITE_ALPHA_INHERIT_BIT_KHR);
}

TEST_F(swapchain, of_a_minimised_window_has_no_images_until_it_is_made_again) {
  for (const VkExtent2D nothing : {VkExtent2D{0, 200}, VkExtent2D{320, 0}}) {
    Swapchain chain(*device_, nothing);
    EXPECT_EQ(chain.image_count(), 0u);
    EXPECT_TRUE(chain.fits(nothing));
    EXPECT_FALSE(chain.acquire(VK_NULL_HANDLE));
    EXPECT_FALSE(chain.fits(nothing));
    chain.remake({320, 200});
    EXPECT_EQ(chain.image_count(), 3u);
    EXPECT_TRUE(chain.fits({320, 200}));
  }
  own_driver().surface.currentExtent = {1, 1};
  EXPECT_EQ(Swapchain(*device_, {1, 1}).image_count(), 3u) << "a pixel is an area";
  own_driver().surface.currentExtent = {320, 0};
  EXPECT_EQ(Swapchain(*device_, {320, 200}).image_count(), 0u) << "the surface says so";
}

TEST_F(swapchain, is_made_again_from_the_old_one) {
  { const Swapchain made(*device_, {320, 200}); }
  EXPECT_EQ(own_driver().waits, 1) << "until nothing draws to it any more";
  own_driver().waits = 0;
  Swapchain chain(*device_, {320, 200});
  EXPECT_EQ(own_driver().swapchains.back().oldSwapchain, VK_NULL_HANDLE);
  EXPECT_FALSE(chain.fits({321, 200}));
  EXPECT_FALSE(chain.fits({320, 201}));
  chain.remake({321, 200});
  EXPECT_NE(own_driver().swapchains.back().oldSwapchain, VK_NULL_HANDLE);
  EXPECT_TRUE(chain.fits({321, 200}));
  EXPECT_EQ(chain.image_count(), 3u) << "those of the old one are gone";
  EXPECT_EQ(own_driver().waits, 1) << "until nothing draws to them";
  const int alive = own_driver().alive;
  chain.remake({320, 200});
  EXPECT_EQ(own_driver().alive, alive);
  chain.remake({0, 0});
  EXPECT_EQ(chain.image_count(), 0u);
  EXPECT_EQ(own_driver().waits, 3);
}

TEST_F(swapchain, gives_the_next_image_and_tells_when_it_no_longer_fits) {
  Swapchain chain(*device_, {320, 200});
  const auto acquire = [&](VkResult answer) {
    own_driver().on_acquire = answer;
    return chain.acquire(VK_NULL_HANDLE);
  };
  EXPECT_EQ(acquire(VK_SUCCESS), 1u);
  EXPECT_EQ(acquire(VK_TIMEOUT), std::nullopt);
  EXPECT_EQ(acquire(VK_NOT_READY), std::nullopt);
  EXPECT_TRUE(chain.fits({320, 200}));
  EXPECT_EQ(acquire(VK_SUBOPTIMAL_KHR), 1u) << "it can still be drawn";
  EXPECT_FALSE(chain.fits({320, 200}));
  chain.remake({320, 200});
  EXPECT_EQ(acquire(VK_ERROR_OUT_OF_DATE_KHR), std::nullopt);
  EXPECT_FALSE(chain.fits({320, 200}));
  EXPECT_THROW(acquire(VK_ERROR_SURFACE_LOST_KHR), DeviceError);
}

TEST_F(swapchain, shows_an_image_once_it_is_drawn_and_tells_when_it_no_longer_fits) {
  Swapchain chain(*device_, {320, 200});
  const auto fits_after = [&](VkResult answer) {
    chain.remake({320, 200});
    own_driver().on_present = answer;
    chain.present(2);
    return chain.fits({320, 200});
  };
  EXPECT_TRUE(fits_after(VK_SUCCESS));
  EXPECT_THAT(own_driver().presented, ElementsAre(2));
  EXPECT_EQ(own_driver().waited_for, chain.drawn(2));
  EXPECT_NE(own_driver().shown_on, VK_NULL_HANDLE);
  EXPECT_FALSE(fits_after(VK_SUBOPTIMAL_KHR));
  EXPECT_FALSE(fits_after(VK_ERROR_OUT_OF_DATE_KHR));
  EXPECT_THROW(fits_after(VK_ERROR_SURFACE_LOST_KHR), DeviceError);
}

}  // namespace
}  // namespace sinew::viewer
