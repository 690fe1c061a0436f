// SPDX-License-Identifier: MIT
// Compiled pipelines are kept for the next run. Uses a fake driver: this program defines the four Vulkan functions that
// the cache calls, and its definitions take precedence over the library's.
#include "viewer/device/pipeline_cache.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

namespace sinew::viewer {
namespace {

namespace fs = std::filesystem;
using Bytes = std::vector<std::byte>;
using testing::ElementsAre;

/// A fake driver with one device. Records its inputs; tests set its answers.
struct Driver {
  VkPhysicalDeviceProperties device{};
  Bytes data;             ///< data returned by vkGetPipelineCacheData
  std::size_t fewer = 0;  ///< number of bytes by which the result is shorter than announced
  VkResult on_size = VK_SUCCESS, on_data = VK_SUCCESS;
  bool takes_data = true, makes_caches = true;
  std::vector<Bytes> given;  ///< initial data of each created cache
  int asked = 0, alive = 0;

  Driver() {
    device.vendorID = 0x10de;
    device.deviceID = 0x2335;
    device.driverVersion = 7;
    device.pipelineCacheUUID[3] = 7;
  }
};
Driver driver;

/// Data that begin with the header of a device, then `more` bytes.
Bytes data_for(const VkPhysicalDeviceProperties& device, std::size_t more, std::byte filling = std::byte{1}) {
  VkPipelineCacheHeaderVersionOne header{
      sizeof header, VK_PIPELINE_CACHE_HEADER_VERSION_ONE, device.vendorID, device.deviceID, {}};
  std::memcpy(header.pipelineCacheUUID, device.pipelineCacheUUID, VK_UUID_SIZE);
  Bytes data(sizeof header + more, filling);
  std::memcpy(data.data(), &header, sizeof header);
  return data;
}

class pipeline_cache : public testing::Test {
 protected:
  void SetUp() override {
    driver = {};
    driver.data = data_for(driver.device, 100);
    fs::remove_all(folder_);
  }
  void TearDown() override {
    EXPECT_EQ(driver.alive, 0) << "every cache is destroyed, once";
    fs::remove_all(folder_);
  }

  /// One run of a program: makes the cache, compiles, and ends.
  void run() const { const PipelineCache cache(VK_NULL_HANDLE, VK_NULL_HANDLE, DiskCache(folder_)); }

  /// The data that the driver receives in another run.
  Bytes given_next() const {
    driver.given.clear();
    run();
    return driver.given.empty() ? Bytes() : driver.given.front();
  }
  std::vector<std::string> files() const {
    std::vector<std::string> names;
    if (fs::exists(folder_))
      for (const auto& file : fs::directory_iterator(folder_)) names.push_back(file.path().filename());
    return names;
  }

  fs::path folder_ = fs::temp_directory_path() / ("pipeline_cache" + std::to_string(::getpid()));
};

TEST_F(pipeline_cache, gives_the_driver_in_the_next_run_what_it_compiled) {
  run();
  EXPECT_THAT(driver.given, ElementsAre(Bytes())) << "the first run has nothing";
  EXPECT_THAT(files(), ElementsAre("10de-2335.pipelines"));
  EXPECT_EQ(given_next(), data_for(driver.device, 100));
}

TEST_F(pipeline_cache, is_stored_again_only_when_pipelines_were_added) {
  run();
  const fs::path file = folder_ / "10de-2335.pipelines";
  const auto before = fs::last_write_time(file) - std::chrono::hours(1);
  fs::last_write_time(file, before);
  run();
  EXPECT_EQ(fs::last_write_time(file), before) << "nothing was added";
  driver.data = data_for(driver.device, 150);
  run();
  EXPECT_EQ(given_next(), driver.data);
}

TEST_F(pipeline_cache, of_another_version_of_the_driver_is_not_loaded_and_is_replaced) {
  const auto is_another = [&](auto change) {
    driver = {};
    driver.data = data_for(driver.device, 100);
    run();
    change(driver.device);
    driver.data = data_for(driver.device, 50);
    EXPECT_EQ(given_next(), Bytes());
    EXPECT_EQ(files().size(), 1u);
    EXPECT_EQ(given_next(), driver.data);
  };
  is_another([](auto& device) { ++device.driverVersion; });
  is_another([](auto& device) { ++device.apiVersion; });
  is_another([](auto& device) { ++device.pipelineCacheUUID[15]; });
}

TEST_F(pipeline_cache, each_device_has_a_file_of_its_own) {
  run();
  driver.device.deviceID = 0x1;
  driver.data = data_for(driver.device, 10);
  EXPECT_EQ(given_next(), Bytes());
  EXPECT_THAT(files(), testing::UnorderedElementsAre("10de-2335.pipelines", "10de-0001.pipelines"));
}

TEST_F(pipeline_cache, begins_empty_where_the_driver_refuses_what_was_stored) {
  run();
  driver.takes_data = false;
  driver.given.clear();
  run();
  EXPECT_THAT(driver.given, ElementsAre(driver.data, Bytes()));
  driver.makes_caches = false;
  driver.given.clear();
  EXPECT_THROW(run(), DeviceError);
  EXPECT_EQ(driver.given.size(), 2u) << "with the data, and without";
}

TEST_F(pipeline_cache, a_driver_that_makes_none_is_an_error_and_is_asked_once) {
  driver.makes_caches = false;
  EXPECT_THROW(run(), DeviceError);
  EXPECT_EQ(driver.given.size(), 1u);
}

TEST_F(pipeline_cache, is_not_stored_where_the_driver_does_not_give_it) {
  driver.on_size = VK_ERROR_OUT_OF_HOST_MEMORY;
  run();
  EXPECT_EQ(driver.asked, 1);
  driver.on_size = VK_SUCCESS;
  driver.on_data = VK_INCOMPLETE;
  run();
  EXPECT_TRUE(files().empty());
}

TEST_F(pipeline_cache, is_not_stored_without_pipelines_in_it) {
  driver.data = data_for(driver.device, 0);
  run();
  EXPECT_TRUE(files().empty()) << "the header alone";
  driver.data = data_for(driver.device, 1);
  run();
  EXPECT_EQ(files().size(), 1u);
}

TEST_F(pipeline_cache, has_the_bytes_that_the_driver_wrote_and_no_more) {
  driver.fewer = 30;
  run();
  EXPECT_EQ(given_next(), data_for(driver.device, 70));
}

TEST_F(pipeline_cache, without_a_disk_is_not_asked_for) {
  { const PipelineCache cache(VK_NULL_HANDLE, VK_NULL_HANDLE, DiskCache()); }
  EXPECT_EQ(driver.asked, 0);
  EXPECT_THAT(driver.given, ElementsAre(Bytes()));
}

TEST_F(pipeline_cache, data_of_another_device_in_its_file_are_not_given_to_the_driver) {
  VkPhysicalDeviceProperties other = driver.device;
  other.vendorID = 0x1002;
  driver.data = data_for(other, 100);
  run();
  EXPECT_EQ(given_next(), Bytes());
}

TEST_F(pipeline_cache, takes_only_data_of_this_device_and_driver) {
  const auto data_with = [&](auto change) {
    Bytes data = data_for(driver.device, 16);
    VkPipelineCacheHeaderVersionOne header;
    std::memcpy(&header, data.data(), sizeof header);
    change(header);
    std::memcpy(data.data(), &header, sizeof header);
    return data;
  };
  const auto takes = [&](std::span<const std::byte> data) { return holds_pipelines_for(driver.device, data); };
  const auto as_it_is = data_with([](auto&) {});
  EXPECT_TRUE(takes(as_it_is));
  EXPECT_FALSE(takes(std::span(as_it_is).first(32))) << "the header alone";
  EXPECT_FALSE(takes({}));
  EXPECT_TRUE(takes(data_with([](auto& h) { h.headerSize += 4; }))) << "a longer header begins like this one";
  EXPECT_FALSE(takes(data_with([](auto& h) { h.vendorID = 0x1002; })));
  EXPECT_FALSE(takes(data_with([](auto& h) { h.deviceID = 1; })));
  EXPECT_FALSE(takes(data_with([](auto& h) { h.pipelineCacheUUID[15] = 1; })));
  EXPECT_FALSE(takes(data_with([](auto& h) { h.headerSize = 16; })));
  EXPECT_FALSE(takes(data_with([](auto& h) { h.headerVersion = static_cast<VkPipelineCacheHeaderVersion>(2); })));
}

}  // namespace

extern "C" {

VKAPI_ATTR void VKAPI_CALL vkGetPhysicalDeviceProperties(VkPhysicalDevice, VkPhysicalDeviceProperties* properties) {
  *properties = driver.device;
}

VKAPI_ATTR VkResult VKAPI_CALL vkCreatePipelineCache(VkDevice, const VkPipelineCacheCreateInfo* info,
                                                     const VkAllocationCallbacks*, VkPipelineCache* cache) {
  EXPECT_EQ(info->sType, VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO);
  const auto* first = static_cast<const std::byte*>(info->pInitialData);
  driver.given.emplace_back(first, first + info->initialDataSize);
  if (!driver.makes_caches || (!driver.takes_data && info->initialDataSize > 0)) return VK_ERROR_INITIALIZATION_FAILED;
  ++driver.alive;
  *cache = reinterpret_cast<VkPipelineCache>(&driver);
  return VK_SUCCESS;
}

VKAPI_ATTR VkResult VKAPI_CALL vkGetPipelineCacheData(VkDevice, VkPipelineCache cache, std::size_t* size, void* data) {
  EXPECT_EQ(cache, reinterpret_cast<VkPipelineCache>(&driver));
  ++driver.asked;
  if (data == nullptr) {
    *size = driver.data.size();
    return driver.on_size;
  }
  EXPECT_EQ(*size, driver.data.size());
  *size -= driver.fewer;
  std::memcpy(data, driver.data.data(), *size);
  return driver.on_data;
}

VKAPI_ATTR void VKAPI_CALL vkDestroyPipelineCache(VkDevice, VkPipelineCache cache, const VkAllocationCallbacks*) {
  EXPECT_EQ(cache, reinterpret_cast<VkPipelineCache>(&driver));
  --driver.alive;
}

}  // extern "C"
}  // namespace sinew::viewer
