// SPDX-License-Identifier: MIT
#include "viewer/device/device_error.h"

#include <gtest/gtest.h>

#include <string>

#include <vulkan/vulkan.h>

namespace sinew::viewer {
namespace {

std::string said_of(VkResult result) {
  try {
    must(result, "create an image");
  } catch (const DeviceError& error) {
    return error.what();
  }
  return "";
}

TEST(device_error, results_that_are_no_errors_go_on) {
  for (const VkResult result : {VK_SUCCESS, VK_NOT_READY, VK_TIMEOUT, VK_INCOMPLETE, VK_SUBOPTIMAL_KHR})
    EXPECT_EQ(said_of(result), "") << result;
}

TEST(device_error, says_what_failed_and_the_error_in_words_and_by_its_number) {
  const auto expect = [](VkResult result, const std::string& words) {
    EXPECT_EQ(said_of(result), "Vulkan: create an image: " + words + " (" + std::to_string(result) + ")");
  };
  expect(VK_ERROR_OUT_OF_HOST_MEMORY, "out of host memory");
  expect(VK_ERROR_OUT_OF_DEVICE_MEMORY, "out of device memory");
  expect(VK_ERROR_INITIALIZATION_FAILED, "initialisation failed");
  expect(VK_ERROR_DEVICE_LOST, "device lost");
  expect(VK_ERROR_LAYER_NOT_PRESENT, "layer not present");
  expect(VK_ERROR_EXTENSION_NOT_PRESENT, "extension not present");
  expect(VK_ERROR_FEATURE_NOT_PRESENT, "feature not present");
  expect(VK_ERROR_INCOMPATIBLE_DRIVER, "no Vulkan driver is installed");
  expect(VK_ERROR_TOO_MANY_OBJECTS, "too many objects");
  expect(VK_ERROR_FORMAT_NOT_SUPPORTED, "format not supported");
  expect(VK_ERROR_OUT_OF_POOL_MEMORY, "out of pool memory");
  expect(VK_ERROR_FRAGMENTED_POOL, "fragmented pool");
  expect(VK_ERROR_SURFACE_LOST_KHR, "surface lost");
  expect(VK_ERROR_NATIVE_WINDOW_IN_USE_KHR, "window already in use");
  expect(VK_ERROR_OUT_OF_DATE_KHR, "surface out of date");
  expect(VK_ERROR_UNKNOWN, "unknown error");
}

}  // namespace
}  // namespace sinew::viewer
