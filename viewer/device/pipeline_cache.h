// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "viewer/device/device_error.h"
#include "viewer/device/disk_cache.h"

namespace sinew::viewer {

/// A VkPipelineCache that is kept on disk between runs, if the driver exports its data. Data of another device or
/// driver version is not loaded.
class PipelineCache {
 public:
  /// err  DeviceError if the driver cannot create a cache
  PipelineCache(VkPhysicalDevice physical, VkDevice device, const DiskCache& disk);
  /// Stores the cache if pipelines were added.
  ~PipelineCache();
  PipelineCache(const PipelineCache&) = delete;
  PipelineCache& operator=(const PipelineCache&) = delete;

  VkPipelineCache handle() const noexcept { return cache_; }

 private:
  void store() const;

  VkDevice device_;
  DiskCache disk_;
  std::string name_;
  std::uint64_t key_ = 0;              ///< identifies device and driver version
  std::uint64_t loaded_checksum_ = 0;  ///< 0 = nothing was loaded
  VkPipelineCache cache_ = VK_NULL_HANDLE;
};

/// True if the data starts with Vulkan's pipeline cache header for this device and driver, and is longer than the
/// header.
bool holds_pipelines_for(const VkPhysicalDeviceProperties& device, std::span<const std::byte> data) noexcept;

}  // namespace sinew::viewer
