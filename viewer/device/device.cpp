// SPDX-License-Identifier: MIT
#include "viewer/device/device.h"

#include <cstdio>

#include "viewer/device/device_choice.h"
#include "viewer/device/validation.h"

namespace sinew::viewer {

Device::Device(const DeviceOptions& options) : on_message_(options.on_message) {
  if (!on_message_)
    on_message_ = [](std::string_view text) {
      std::fprintf(stderr, "%.*s\n", static_cast<int>(text.size()), text.data());
    };
  try {
    create_instance(options);
    if (options.make_surface) surface_ = options.make_surface(instance_);
    choose_physical();
    create_device();
    memory_ = std::make_unique<Memory>(physical_, device_);
    pipeline_cache_ = std::make_unique<PipelineCache>(physical_, device_, options.disk_cache);
  } catch (...) {
    destroy();
    throw;
  }
}

Device::~Device() { destroy(); }

void Device::destroy() noexcept {
  pipeline_cache_.reset();
  memory_.reset();
  if (pool_) vkDestroyCommandPool(device_, pool_, nullptr);
  if (device_) vkDestroyDevice(device_, nullptr);
  if (surface_) vkDestroySurfaceKHR(instance_, surface_, nullptr);
  if (messenger_) destroy_messenger(instance_, messenger_);
  if (instance_) vkDestroyInstance(instance_, nullptr);
}

void Device::create_instance(const DeviceOptions& options) {
  const bool validate = options.validation && validation_installed();
  if (options.validation && !validate) on_message_("validation was asked for, but the Khronos layer is not installed");
  std::uint32_t loader_version = VK_API_VERSION_1_0;
  vkEnumerateInstanceVersion(&loader_version);
  if (loader_version < VK_API_VERSION_1_3) throw DeviceError("Vulkan: the loader is older than version 1.3");

  VkApplicationInfo application{VK_STRUCTURE_TYPE_APPLICATION_INFO};
  application.pApplicationName = "sinew-viewer";
  application.apiVersion = VK_API_VERSION_1_3;
  VkInstanceCreateInfo info{VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO};
  info.pApplicationInfo = &application;
  std::vector<const char*> extensions = options.instance_extensions;
  ValidationRequest request(&Device::message, this);
  if (validate) request.add_to(info, extensions);
  info.enabledExtensionCount = static_cast<std::uint32_t>(extensions.size());
  info.ppEnabledExtensionNames = extensions.data();
  must(vkCreateInstance(&info, nullptr, &instance_), "vkCreateInstance");
  if (validate) messenger_ = request.create_messenger(instance_);
}

void Device::choose_physical() {
  const DeviceChoice choice = choose_device(instance_, surface_);
  physical_ = choice.physical;
  queue_family_ = choice.queue_family;
  timestamp_bits_ = choice.timestamp_bits;
  VkPhysicalDeviceProperties properties{};
  vkGetPhysicalDeviceProperties(physical_, &properties);
  name_ = properties.deviceName;
  limits_ = properties.limits;
  is_software_ = properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
}

void Device::create_device() {
  VkPhysicalDeviceFeatures offered{};
  vkGetPhysicalDeviceFeatures(physical_, &offered);
  VkPhysicalDeviceVulkan13Features features13{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
  features13.dynamicRendering = VK_TRUE;
  features13.synchronization2 = VK_TRUE;
  features13.maintenance4 = VK_TRUE;  // mandatory in 1.3; lets a fragment shader ignore outputs of the vertex shader
  VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &features13, {}};
  features.features.samplerAnisotropy = offered.samplerAnisotropy;
  features.features.independentBlend = VK_TRUE;
  features.features.largePoints = offered.largePoints;
  features.features.fullDrawIndexUint32 =
      offered.fullDrawIndexUint32;  // without it meshes are limited to 2^24 vertices
  max_anisotropy_ = offered.samplerAnisotropy ? limits_.maxSamplerAnisotropy : 1.0f;
  max_point_size_ = offered.largePoints ? limits_.pointSizeRange[1] : 1.0f;

  const float priority = 1.0f;
  VkDeviceQueueCreateInfo queue{VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
  queue.queueFamilyIndex = queue_family_;
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;
  const char* swapchain = VK_KHR_SWAPCHAIN_EXTENSION_NAME;
  VkDeviceCreateInfo info{VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO, &features};
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  info.enabledExtensionCount = surface_ ? 1 : 0;
  info.ppEnabledExtensionNames = &swapchain;
  must(vkCreateDevice(physical_, &info, nullptr, &device_), "vkCreateDevice");
  vkGetDeviceQueue(device_, queue_family_, 0, &queue_);

  VkCommandPoolCreateInfo pool{VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
  pool.flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT;
  pool.queueFamilyIndex = queue_family_;
  must(vkCreateCommandPool(device_, &pool, nullptr, &pool_), "vkCreateCommandPool");
}

void Device::run_now(const std::function<void(VkCommandBuffer)>& record) const {
  VkCommandBufferAllocateInfo allocate{VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
  allocate.commandPool = pool_;
  allocate.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  allocate.commandBufferCount = 1;
  VkCommandBuffer commands = VK_NULL_HANDLE;
  must(vkAllocateCommandBuffers(device_, &allocate, &commands), "vkAllocateCommandBuffers");
  VkCommandBufferBeginInfo begin{VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
  begin.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
  must(vkBeginCommandBuffer(commands, &begin), "vkBeginCommandBuffer");
  record(commands);
  must(vkEndCommandBuffer(commands), "vkEndCommandBuffer");
  VkCommandBufferSubmitInfo buffer{VK_STRUCTURE_TYPE_COMMAND_BUFFER_SUBMIT_INFO};
  buffer.commandBuffer = commands;
  VkSubmitInfo2 submit{VK_STRUCTURE_TYPE_SUBMIT_INFO_2};
  submit.commandBufferInfoCount = 1;
  submit.pCommandBufferInfos = &buffer;
  must(vkQueueSubmit2(queue_, 1, &submit, VK_NULL_HANDLE), "vkQueueSubmit2");
  must(vkQueueWaitIdle(queue_), "vkQueueWaitIdle");
  vkFreeCommandBuffers(device_, pool_, 1, &commands);
}

void Device::wait_idle() const { must(vkDeviceWaitIdle(device_), "vkDeviceWaitIdle"); }

VKAPI_ATTR VkBool32 VKAPI_CALL Device::message(VkDebugUtilsMessageSeverityFlagBitsEXT, VkDebugUtilsMessageTypeFlagsEXT,
                                               const VkDebugUtilsMessengerCallbackDataEXT* data, void* device) {
  auto* self = static_cast<Device*>(device);
  self->messages_.fetch_add(1);
  self->on_message_(data->pMessage);
  return VK_FALSE;
}

}  // namespace sinew::viewer
