// SPDX-License-Identifier: MIT
#pragma once
#include <gtest/gtest.h>

#include "tests/viewer/float_picture.h"

namespace sinew::viewer {

/// Graphics cards snap vertices to a grid of this size in pixels; Mesa's software driver does not.
inline double vertex_grid_px() { return test_device()->is_software() ? 0.0 : 1.0 / 256.0; }

/// Base of tests that draw. Skips with a reason if there is no Vulkan device, and fails on any validation message.
/// Tests that check for silence skip if the validation layer is missing.
class DeviceTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!test_device()) GTEST_SKIP() << no_device_reason();
    messages_before_ = test_device()->validation_messages();
  }
  void TearDown() override {
    if (!test_device()) return;
    EXPECT_EQ(test_device()->validation_messages(), messages_before_);
  }

 private:
  std::uint64_t messages_before_ = 0;
};

}  // namespace sinew::viewer
