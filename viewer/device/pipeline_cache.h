// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "viewer/device/device_error.h"
#include "viewer/device/disk_cache.h"

namespace sinew::viewer {

/// What the driver compiled, kept for the next run where the driver gives it. A cache of another device or of another
/// version of the driver is not loaded.
class PipelineCache {
 public:
  /// err  DeviceError when the driver makes no cache
  PipelineCache(VkPhysicalDevice physical, VkDevice device, const DiskCache& disk);
  /// Stores the cache when pipelines were added to it.
  ~PipelineCache();
  PipelineCache(const PipelineCache&) = delete;
  PipelineCache& operator=(const PipelineCache&) = delete;

  VkPipelineCache handle() const noexcept { return cache_; }

 private:
  void store() const;

  VkDevice device_;
  DiskCache disk_;
  std::string name_;
  std::uint64_t key_ = 0;              ///< of device and driver
  std::uint64_t loaded_checksum_ = 0;  ///< 0 = nothing was loaded
  VkPipelineCache cache_ = VK_NULL_HANDLE;
};

/// The data begin with the header that Vulkan prescribes, of this device and driver, and hold more than that.
bool holds_pipelines_for(const VkPhysicalDeviceProperties& device, std::span<const std::byte> data) noexcept;

}  // namespace sinew::viewer
