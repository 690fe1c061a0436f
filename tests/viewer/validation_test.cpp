// SPDX-License-Identifier: MIT
// Invalid calls, made on purpose: the validation layer reports them through the device.
#include "viewer/device/validation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "viewer/device/buffer.h"

namespace sinew::viewer {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

class validation : public testing::Test {
 protected:
  void SetUp() override {
    if (!validation_installed()) GTEST_SKIP() << "the validation layer is not installed";
    try {
      device_ = std::make_unique<Device>(DeviceOptions{
          .validation = true, .on_message = [this](std::string_view text) { messages_.emplace_back(text); }});
    } catch (const DeviceError& error) {
      GTEST_SKIP() << error.what();
    }
  }

  std::vector<std::string> messages_;
  std::unique_ptr<Device> device_;
};

TEST_F(validation, tells_of_a_faulty_call_and_counts_it) {
  EXPECT_TRUE(device_->validation_active());
  EXPECT_EQ(device_->validation_messages(), 0u);
  const VkFenceCreateInfo not_one{VK_STRUCTURE_TYPE_EVENT_CREATE_INFO};
  VkFence fence = VK_NULL_HANDLE;
  vkCreateFence(device_->handle(), &not_one, nullptr, &fence);
  vkDestroyFence(device_->handle(), fence, nullptr);
  EXPECT_THAT(messages_, Contains(HasSubstr("VUID-VkFenceCreateInfo-sType")));
  EXPECT_EQ(device_->validation_messages(), messages_.size());
}

TEST_F(validation, tells_of_writes_without_a_barrier_between_them) {
  const Buffer buffer(*device_, 256, VK_BUFFER_USAGE_TRANSFER_DST_BIT, MemoryUse::device);
  const auto fill = [&](VkCommandBuffer commands) { vkCmdFillBuffer(commands, buffer.handle(), 0, 256, 0); };
  device_->run_now(fill);
  EXPECT_THAT(messages_, IsEmpty());
  device_->run_now([&](VkCommandBuffer commands) {
    fill(commands);
    fill(commands);
  });
  EXPECT_THAT(messages_, Contains(HasSubstr("SYNC-HAZARD-WRITE")));
}

TEST(device, without_validation_has_no_messages) {
  try {
    const Device device;
    EXPECT_FALSE(device.validation_active());
    EXPECT_EQ(device.validation_messages(), 0u);
  } catch (const DeviceError& error) {
    GTEST_SKIP() << error.what();
  }
}

}  // namespace
}  // namespace sinew::viewer
