// SPDX-License-Identifier: MIT
// Buffers and images on a fake driver whose calls fail one after another.
#include <gtest/gtest.h>

#include <utility>

#include "tests/viewer/own_driver.h"
#include "viewer/device/buffer.h"
#include "viewer/device/image.h"

namespace sinew::viewer {
namespace {

class device_objects : public OwnDriverTest {
 protected:
  void SetUp() override {
    OwnDriverTest::SetUp();
    own_driver().memory.memoryTypeCount = 1;
    own_driver().memory.memoryTypes[0].propertyFlags = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT |
                                                       VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT |
                                                       VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
  }

  static Buffer buffer(const Device& device) {
    return Buffer(device, 100, VK_BUFFER_USAGE_VERTEX_BUFFER_BIT, MemoryUse::device);
  }
  static GpuImage image(const Device& device) { return GpuImage(device, {VK_FORMAT_R8G8B8A8_UNORM, {8, 8}}); }
};

TEST_F(device_objects, that_cannot_be_made_leave_nothing_behind) {
  const Device device;
  const int before = own_driver().alive;
  const auto nothing_stays = [&] {
    EXPECT_THROW(buffer(device), DeviceError);
    EXPECT_THROW(image(device), DeviceError);
    EXPECT_EQ(device.memory().block_count(), 0u);
    EXPECT_EQ(own_driver().alive, before);
  };
  own_driver().room = {0};
  nothing_stays();
  own_driver().room = {};
  own_driver().on_bind = VK_ERROR_OUT_OF_DEVICE_MEMORY;
  nothing_stays();
  own_driver().on_bind = VK_SUCCESS;
  own_driver().on_view = VK_ERROR_OUT_OF_HOST_MEMORY;
  EXPECT_THROW(image(device), DeviceError);
  EXPECT_EQ(device.memory().block_count(), 0u);
  EXPECT_EQ(own_driver().alive, before);
}

TEST_F(device_objects, that_are_moved_are_destroyed_once) {
  const Device device;
  const int before = own_driver().alive;
  {
    Buffer first = buffer(device);
    const VkBuffer handle = first.handle();
    Buffer second(std::move(first));
    EXPECT_EQ(second.handle(), handle);
    second = buffer(device);
    EXPECT_NE(second.handle(), handle);

    GpuImage drawn = image(device);
    const VkImage drawn_handle = drawn.handle();
    const GpuImage kept(std::move(drawn));
    EXPECT_EQ(kept.handle(), drawn_handle);
    EXPECT_FALSE(drawn);  // NOLINT(bugprone-use-after-move)
  }
  EXPECT_EQ(device.memory().block_count(), 0u);
  EXPECT_EQ(own_driver().alive, before);
}

}  // namespace
}  // namespace sinew::viewer
