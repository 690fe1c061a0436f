// SPDX-License-Identifier: MIT
// The program's definitions take precedence over those of the library.
#include "tests/viewer/own_driver.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

namespace sinew::viewer {
namespace {

std::size_t last_handle = 0;

/// Creates a new fake object of any type.
template <typename Handle>
VkResult make(Handle* handle) {
  ++own_driver().alive;
  *handle = reinterpret_cast<Handle>(++last_handle);
  return VK_SUCCESS;
}

template <typename Handle>
void destroy(Handle handle) {
  if (handle) --own_driver().alive;
}

OwnDevice& device_of(VkPhysicalDevice device) {
  return own_driver().devices.at(reinterpret_cast<std::size_t>(device) - 1);
}

/// Implements a Vulkan enumeration: the count only, or as many entries as fit.
template <typename T>
VkResult list(const std::vector<T>& all, std::uint32_t* count, T* out) {
  const auto length = static_cast<std::uint32_t>(all.size());
  *count = out == nullptr ? length : std::min(*count, length);
  if (out != nullptr) std::copy_n(all.begin(), *count, out);
  return VK_SUCCESS;
}

}  // namespace

OwnDevice::OwnDevice(const std::string& name, VkPhysicalDeviceType type) {
  std::strncpy(properties.deviceName, name.c_str(), sizeof(properties.deviceName) - 1);
  properties.deviceType = type;
  properties.apiVersion = VK_API_VERSION_1_3;
  properties.limits.timestampPeriod = 1.0f;
  features.independentBlend = VK_TRUE;
  queues = {{VK_QUEUE_GRAPHICS_BIT, 1, 64, {}}};
  extensions = {"VK_KHR_another", VK_KHR_SWAPCHAIN_EXTENSION_NAME};
}

OwnDriver& own_driver() {
  static OwnDriver driver;
  return driver;
}

VkSurfaceKHR own_surface() {
  VkSurfaceKHR surface = VK_NULL_HANDLE;
  make(&surface);
  return surface;
}

extern "C" {

// -- instances and devices

VKAPI_ATTR VkResult VKAPI_CALL vkEnumerateInstanceVersion(std::uint32_t* version) {
  *version = own_driver().loader_version;
  return VK_SUCCESS;
}
VKAPI_ATTR VkResult VKAPI_CALL vkCreateInstance(const VkInstanceCreateInfo*, const VkAllocationCallbacks*,
                                                VkInstance* instance) {
  return make(instance);
}
VKAPI_ATTR void VKAPI_CALL vkDestroyInstance(VkInstance instance, const VkAllocationCallbacks*) { destroy(instance); }
VKAPI_ATTR VkResult VKAPI_CALL vkEnumeratePhysicalDevices(VkInstance, std::uint32_t* count, VkPhysicalDevice* devices) {
  std::vector<VkPhysicalDevice> all;
  for (std::size_t i = 1; i <= own_driver().devices.size(); ++i) all.push_back(reinterpret_cast<VkPhysicalDevice>(i));
  list(all, count, devices);
  if (devices != nullptr) *count -= own_driver().leaving;
  return VK_SUCCESS;
}
VKAPI_ATTR void VKAPI_CALL vkGetPhysicalDeviceProperties(VkPhysicalDevice device,
                                                         VkPhysicalDeviceProperties* properties) {
  *properties = device_of(device).properties;
}
VKAPI_ATTR void VKAPI_CALL vkGetPhysicalDeviceFeatures(VkPhysicalDevice device, VkPhysicalDeviceFeatures* features) {
  *features = device_of(device).features;
}
VKAPI_ATTR void VKAPI_CALL vkGetPhysicalDeviceFeatures2(VkPhysicalDevice device, VkPhysicalDeviceFeatures2* features) {
  features->features = device_of(device).features;
  auto* of13 = static_cast<VkPhysicalDeviceVulkan13Features*>(features->pNext);
  ASSERT_EQ(of13->sType, VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES);
  of13->dynamicRendering = device_of(device).dynamic_rendering;
  of13->synchronization2 = device_of(device).synchronization2;
}
VKAPI_ATTR VkResult VKAPI_CALL vkEnumerateDeviceExtensionProperties(VkPhysicalDevice device, const char*,
                                                                    std::uint32_t* count,
                                                                    VkExtensionProperties* extensions) {
  std::vector<VkExtensionProperties> all;
  for (const std::string& name : device_of(device).extensions)
    std::strncpy(all.emplace_back().extensionName, name.c_str(), VK_MAX_EXTENSION_NAME_SIZE - 1);
  return list(all, count, extensions);
}
VKAPI_ATTR void VKAPI_CALL vkGetPhysicalDeviceQueueFamilyProperties(VkPhysicalDevice device, std::uint32_t* count,
                                                                    VkQueueFamilyProperties* families) {
  list(device_of(device).queues, count, families);
}
VKAPI_ATTR VkResult VKAPI_CALL vkGetPhysicalDeviceSurfaceSupportKHR(VkPhysicalDevice device, std::uint32_t family,
                                                                    VkSurfaceKHR, VkBool32* presents) {
  const std::vector<bool>& named = device_of(device).presents;
  *presents = named.empty() || named.at(family);
  return VK_SUCCESS;
}
VKAPI_ATTR void VKAPI_CALL vkGetPhysicalDeviceMemoryProperties(VkPhysicalDevice,
                                                               VkPhysicalDeviceMemoryProperties* memory) {
  *memory = own_driver().memory;
}
VKAPI_ATTR VkResult VKAPI_CALL vkCreateDevice(VkPhysicalDevice, const VkDeviceCreateInfo* info,
                                              const VkAllocationCallbacks*, VkDevice* device) {
  EXPECT_EQ(info->pQueueCreateInfos->queueCount, 1u);
  EXPECT_LE(*info->pQueueCreateInfos->pQueuePriorities, 1.0f);
  if (info->enabledExtensionCount > 0) {
    EXPECT_STREQ(*info->ppEnabledExtensionNames, VK_KHR_SWAPCHAIN_EXTENSION_NAME);
  }
  own_driver().device_info = *info;
  own_driver().enabled = static_cast<const VkPhysicalDeviceFeatures2*>(info->pNext)->features;
  own_driver().queue_family = info->pQueueCreateInfos->queueFamilyIndex;
  return make(device);
}
VKAPI_ATTR void VKAPI_CALL vkDestroyDevice(VkDevice device, const VkAllocationCallbacks*) { destroy(device); }
VKAPI_ATTR VkResult VKAPI_CALL vkDeviceWaitIdle(VkDevice) {
  ++own_driver().waits;
  return VK_SUCCESS;
}
VKAPI_ATTR void VKAPI_CALL vkGetDeviceQueue(VkDevice, std::uint32_t family, std::uint32_t index, VkQueue* queue) {
  EXPECT_EQ(family, own_driver().queue_family);
  EXPECT_EQ(index, 0u);
  *queue = reinterpret_cast<VkQueue>(std::size_t{1});  // of the device, which destroys it
}
VKAPI_ATTR VkResult VKAPI_CALL vkCreateCommandPool(VkDevice, const VkCommandPoolCreateInfo* info,
                                                   const VkAllocationCallbacks*, VkCommandPool* pool) {
  EXPECT_EQ(info->queueFamilyIndex, own_driver().queue_family);
  return make(pool);
}
VKAPI_ATTR void VKAPI_CALL vkDestroyCommandPool(VkDevice, VkCommandPool pool, const VkAllocationCallbacks*) {
  destroy(pool);
}
VKAPI_ATTR VkResult VKAPI_CALL vkCreatePipelineCache(VkDevice, const VkPipelineCacheCreateInfo*,
                                                     const VkAllocationCallbacks*, VkPipelineCache* cache) {
  return make(cache);
}
VKAPI_ATTR void VKAPI_CALL vkDestroyPipelineCache(VkDevice, VkPipelineCache cache, const VkAllocationCallbacks*) {
  destroy(cache);
}

// -- memory

VKAPI_ATTR VkResult VKAPI_CALL vkAllocateMemory(VkDevice, const VkMemoryAllocateInfo* info,
                                                const VkAllocationCallbacks*, VkDeviceMemory* memory) {
  std::vector<VkDeviceSize>& room = own_driver().room;
  if (!room.empty()) {
    if (info->allocationSize > room.at(info->memoryTypeIndex)) return VK_ERROR_OUT_OF_DEVICE_MEMORY;
    room[info->memoryTypeIndex] -= info->allocationSize;
  }
  own_driver().allocated.push_back(*info);
  return make(memory);
}
VKAPI_ATTR void VKAPI_CALL vkFreeMemory(VkDevice, VkDeviceMemory memory, const VkAllocationCallbacks*) {
  if (memory) own_driver().freed.push_back(memory);
  destroy(memory);
}
VKAPI_ATTR VkResult VKAPI_CALL vkMapMemory(VkDevice, VkDeviceMemory memory, VkDeviceSize offset, VkDeviceSize size,
                                           VkMemoryMapFlags flags, void** mapped) {
  EXPECT_NE(memory, VK_NULL_HANDLE);
  EXPECT_EQ(offset, 0u);
  EXPECT_EQ(size, VK_WHOLE_SIZE);
  EXPECT_EQ(flags, 0u);
  *mapped = reinterpret_cast<void*>(std::size_t{1} << 40);  // nothing is written
  return own_driver().maps ? VK_SUCCESS : VK_ERROR_MEMORY_MAP_FAILED;
}

// -- buffers and images: of 256 bytes, in any memory

VKAPI_ATTR VkResult VKAPI_CALL vkCreateBuffer(VkDevice, const VkBufferCreateInfo*, const VkAllocationCallbacks*,
                                              VkBuffer* buffer) {
  return make(buffer);
}
VKAPI_ATTR void VKAPI_CALL vkDestroyBuffer(VkDevice, VkBuffer buffer, const VkAllocationCallbacks*) { destroy(buffer); }
VKAPI_ATTR void VKAPI_CALL vkGetBufferMemoryRequirements(VkDevice, VkBuffer, VkMemoryRequirements* needs) {
  *needs = {256, 16, ~0u};
}
VKAPI_ATTR VkResult VKAPI_CALL vkBindBufferMemory(VkDevice, VkBuffer, VkDeviceMemory, VkDeviceSize) {
  return own_driver().on_bind;
}
VKAPI_ATTR VkResult VKAPI_CALL vkCreateImage(VkDevice, const VkImageCreateInfo*, const VkAllocationCallbacks*,
                                             VkImage* image) {
  return make(image);
}
VKAPI_ATTR void VKAPI_CALL vkDestroyImage(VkDevice, VkImage image, const VkAllocationCallbacks*) { destroy(image); }
VKAPI_ATTR void VKAPI_CALL vkGetImageMemoryRequirements(VkDevice, VkImage, VkMemoryRequirements* needs) {
  *needs = {256, 16, ~0u};
}
VKAPI_ATTR VkResult VKAPI_CALL vkBindImageMemory(VkDevice, VkImage, VkDeviceMemory, VkDeviceSize) {
  return own_driver().on_bind;
}

// -- surfaces and swapchains

VKAPI_ATTR void VKAPI_CALL vkDestroySurfaceKHR(VkInstance, VkSurfaceKHR surface, const VkAllocationCallbacks*) {
  destroy(surface);
}
VKAPI_ATTR VkResult VKAPI_CALL vkGetPhysicalDeviceSurfaceFormatsKHR(VkPhysicalDevice, VkSurfaceKHR,
                                                                    std::uint32_t* count, VkSurfaceFormatKHR* formats) {
  return list(own_driver().formats, count, formats);
}
VKAPI_ATTR VkResult VKAPI_CALL vkGetPhysicalDeviceSurfaceCapabilitiesKHR(VkPhysicalDevice, VkSurfaceKHR,
                                                                         VkSurfaceCapabilitiesKHR* surface) {
  *surface = own_driver().surface;
  return VK_SUCCESS;
}
VKAPI_ATTR VkResult VKAPI_CALL vkCreateSwapchainKHR(VkDevice, const VkSwapchainCreateInfoKHR* info,
                                                    const VkAllocationCallbacks*, VkSwapchainKHR* swapchain) {
  own_driver().swapchains.push_back(*info);
  return make(swapchain);
}
VKAPI_ATTR void VKAPI_CALL vkDestroySwapchainKHR(VkDevice, VkSwapchainKHR swapchain, const VkAllocationCallbacks*) {
  destroy(swapchain);
}
VKAPI_ATTR VkResult VKAPI_CALL vkGetSwapchainImagesKHR(VkDevice, VkSwapchainKHR, std::uint32_t* count,
                                                       VkImage* images) {
  std::vector<VkImage> all;
  for (std::size_t i = 1; i <= own_driver().swapchains.back().minImageCount; ++i)
    all.push_back(reinterpret_cast<VkImage>(i));
  return list(all, count, images);
}
VKAPI_ATTR VkResult VKAPI_CALL vkCreateImageView(VkDevice, const VkImageViewCreateInfo* info,
                                                 const VkAllocationCallbacks*, VkImageView* view) {
  if (own_driver().on_view != VK_SUCCESS) return own_driver().on_view;
  own_driver().views.push_back(*info);
  return make(view);
}
VKAPI_ATTR void VKAPI_CALL vkDestroyImageView(VkDevice, VkImageView view, const VkAllocationCallbacks*) {
  destroy(view);
}
VKAPI_ATTR VkResult VKAPI_CALL vkCreateSemaphore(VkDevice, const VkSemaphoreCreateInfo*, const VkAllocationCallbacks*,
                                                 VkSemaphore* semaphore) {
  return make(semaphore);
}
VKAPI_ATTR void VKAPI_CALL vkDestroySemaphore(VkDevice, VkSemaphore semaphore, const VkAllocationCallbacks*) {
  destroy(semaphore);
}
VKAPI_ATTR VkResult VKAPI_CALL vkAcquireNextImageKHR(VkDevice, VkSwapchainKHR, std::uint64_t, VkSemaphore, VkFence,
                                                     std::uint32_t* image) {
  *image = 1;
  return own_driver().on_acquire;
}
VKAPI_ATTR VkResult VKAPI_CALL vkQueuePresentKHR(VkQueue, const VkPresentInfoKHR* info) {
  own_driver().shown_on = *info->pSwapchains;
  own_driver().presented.assign(info->pImageIndices, info->pImageIndices + info->swapchainCount);
  own_driver().waited_for = info->waitSemaphoreCount == 1 ? info->pWaitSemaphores[0] : VK_NULL_HANDLE;
  return own_driver().on_present;
}

// -- queries

VKAPI_ATTR VkResult VKAPI_CALL vkCreateQueryPool(VkDevice, const VkQueryPoolCreateInfo* info,
                                                 const VkAllocationCallbacks*, VkQueryPool* pool) {
  EXPECT_EQ(info->queryType, VK_QUERY_TYPE_TIMESTAMP);
  own_driver().ticks.resize(std::max<std::size_t>(own_driver().ticks.size(), info->queryCount));
  return make(pool);
}
VKAPI_ATTR void VKAPI_CALL vkDestroyQueryPool(VkDevice, VkQueryPool pool, const VkAllocationCallbacks*) {
  destroy(pool);
}
VKAPI_ATTR void VKAPI_CALL vkCmdResetQueryPool(VkCommandBuffer, VkQueryPool pool, std::uint32_t first, std::uint32_t) {
  EXPECT_NE(pool, VK_NULL_HANDLE);
  EXPECT_EQ(first, 0u);
  own_driver().marks.clear();
}
VKAPI_ATTR void VKAPI_CALL vkCmdWriteTimestamp2(VkCommandBuffer, VkPipelineStageFlags2, VkQueryPool,
                                                std::uint32_t query) {
  own_driver().marks.push_back(query);
}
VKAPI_ATTR VkResult VKAPI_CALL vkGetQueryPoolResults(VkDevice, VkQueryPool, std::uint32_t first, std::uint32_t count,
                                                     std::size_t bytes, void* data, VkDeviceSize stride,
                                                     VkQueryResultFlags flags) {
  own_driver().query_flags = flags;
  EXPECT_EQ(stride, sizeof(std::uint64_t));
  EXPECT_EQ(bytes, count * stride);
  std::memcpy(data, own_driver().ticks.data() + first, bytes);
  return VK_SUCCESS;
}

// -- pipelines

VKAPI_ATTR VkResult VKAPI_CALL vkCreateShaderModule(VkDevice, const VkShaderModuleCreateInfo*,
                                                    const VkAllocationCallbacks*, VkShaderModule* module) {
  return make(module);
}
VKAPI_ATTR void VKAPI_CALL vkDestroyShaderModule(VkDevice, VkShaderModule module, const VkAllocationCallbacks*) {
  destroy(module);
}
VKAPI_ATTR VkResult VKAPI_CALL vkCreateGraphicsPipelines(VkDevice, VkPipelineCache, std::uint32_t count,
                                                         const VkGraphicsPipelineCreateInfo* info,
                                                         const VkAllocationCallbacks*, VkPipeline* pipeline) {
  EXPECT_EQ(count, 1u);
  own_driver().on_pipeline(*info);
  *pipeline = VK_NULL_HANDLE;
  return VK_SUCCESS;
}

}  // extern "C"
}  // namespace sinew::viewer
