// SPDX-License-Identifier: MIT
#include "viewer/device/pipeline_cache.h"

#include <cstdio>
#include <cstring>
#include <exception>
#include <vector>

#include "runtime/base/checksum.h"

namespace sinew::viewer {
namespace {

std::uint64_t key_of(const VkPhysicalDeviceProperties& device) {
  const std::uint32_t numbers[] = {device.vendorID, device.deviceID, device.driverVersion, device.apiVersion};
  return checksum(std::as_bytes(std::span(device.pipelineCacheUUID)), checksum(std::as_bytes(std::span(numbers))));
}

/// File name: one file for each device. A new driver version overwrites it.
std::string name_of(const VkPhysicalDeviceProperties& device) {
  char name[48];
  std::snprintf(name, sizeof name, "%04x-%04x.pipelines", device.vendorID, device.deviceID);
  return name;
}

VkPipelineCache make_cache(VkDevice device, std::span<const std::byte> data) {
  VkPipelineCacheCreateInfo info{VK_STRUCTURE_TYPE_PIPELINE_CACHE_CREATE_INFO};
  info.initialDataSize = data.size();
  info.pInitialData = data.data();
  VkPipelineCache cache = VK_NULL_HANDLE;
  VkResult result = vkCreatePipelineCache(device, &info, nullptr, &cache);
  if (result != VK_SUCCESS && !data.empty()) {
    info.initialDataSize = 0;
    result = vkCreatePipelineCache(device, &info, nullptr, &cache);
  }
  must(result, "vkCreatePipelineCache");
  return cache;
}

std::vector<std::byte> data_of(VkDevice device, VkPipelineCache cache) {
  std::size_t size = 0;
  if (vkGetPipelineCacheData(device, cache, &size, nullptr) != VK_SUCCESS) return {};
  std::vector<std::byte> data(size);
  if (vkGetPipelineCacheData(device, cache, &size, data.data()) != VK_SUCCESS) return {};
  data.resize(size);
  return data;
}

}  // namespace

bool holds_pipelines_for(const VkPhysicalDeviceProperties& device, std::span<const std::byte> data) noexcept {
  VkPipelineCacheHeaderVersionOne header;
  if (data.size() <= sizeof header) return false;
  std::memcpy(&header, data.data(), sizeof header);
  return header.headerSize >= sizeof header && header.headerVersion == VK_PIPELINE_CACHE_HEADER_VERSION_ONE &&
         header.vendorID == device.vendorID && header.deviceID == device.deviceID &&
         std::memcmp(header.pipelineCacheUUID, device.pipelineCacheUUID, VK_UUID_SIZE) == 0;
}

PipelineCache::PipelineCache(VkPhysicalDevice physical, VkDevice device, const DiskCache& disk)
    : device_(device), disk_(disk) {
  VkPhysicalDeviceProperties properties{};
  vkGetPhysicalDeviceProperties(physical, &properties);
  name_ = name_of(properties);
  key_ = key_of(properties);
  const auto stored = disk_.load(name_, key_);
  const bool fits = stored && holds_pipelines_for(properties, *stored);
  if (fits) loaded_checksum_ = checksum(*stored);
  cache_ = make_cache(device_, fits ? std::span<const std::byte>(*stored) : std::span<const std::byte>());
}

PipelineCache::~PipelineCache() {
  try {
    if (disk_.on()) store();
  } catch (const std::exception&) {  // out of memory or disk error: the next run compiles again
  }
  vkDestroyPipelineCache(device_, cache_, nullptr);
}

void PipelineCache::store() const {
  const std::vector<std::byte> data = data_of(device_, cache_);
  // Empty: this driver keeps compiled code in its own cache.
  if (data.size() <= sizeof(VkPipelineCacheHeaderVersionOne)) return;
  if (checksum(data) != loaded_checksum_) disk_.store(name_, key_, data);
}

}  // namespace sinew::viewer
