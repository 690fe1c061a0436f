// SPDX-License-Identifier: MIT
#pragma once
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "viewer/device/device_error.h"
#include "viewer/device/memory.h"
#include "viewer/device/pipeline_cache.h"

namespace sinew::viewer {

struct DeviceOptions {
  bool validation = false;  ///< use the Khronos layer with synchronisation checks, if installed
  std::function<void(std::string_view)> on_message;      ///< validation messages; empty = standard error
  DiskCache disk_cache;                                  ///< for compiled pipelines
  std::vector<const char*> instance_extensions;          ///< extensions that the window system needs; empty = headless
  std::function<VkSurfaceKHR(VkInstance)> make_surface;  ///< empty = headless; the device owns the surface
};

/// Owns the Vulkan instance, the device, its memory, and one queue for graphics, copies and presentation. Needs Vulkan
/// 1.3 with dynamic rendering and synchronization2. Independent of the window library: the application passes instance
/// extensions and a surface.
class Device {
 public:
  /// err  DeviceError if no device is suitable; the message lists what each device lacks
  explicit Device(const DeviceOptions& options = {});
  ~Device();
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  VkInstance instance() const noexcept { return instance_; }
  VkPhysicalDevice physical() const noexcept { return physical_; }
  VkDevice handle() const noexcept { return device_; }
  VkQueue queue() const noexcept { return queue_; }
  std::uint32_t queue_family() const noexcept { return queue_family_; }
  VkSurfaceKHR surface() const noexcept { return surface_; }  ///< null when headless
  const std::string& name() const noexcept { return name_; }
  const VkPhysicalDeviceLimits& limits() const noexcept { return limits_; }
  bool is_software() const noexcept { return is_software_; }         ///< the driver renders on the CPU
  float max_anisotropy() const noexcept { return max_anisotropy_; }  ///< 1 if the device has no anisotropic filter
  float max_point_size() const noexcept { return max_point_size_; }
  std::uint32_t timestamp_bits() const noexcept { return timestamp_bits_; }  ///< 0 = the queue has no timestamps
  Memory& memory() const noexcept { return *memory_; }
  VkPipelineCache pipeline_cache() const noexcept { return pipeline_cache_->handle(); }

  /// A number that this device has not given before.
  std::uint64_t next_number() noexcept { return ++numbers_; }

  /// Number of validation errors and warnings so far; 0 without validation.
  std::uint64_t validation_messages() const noexcept { return messages_.load(); }
  bool validation_active() const noexcept { return messenger_ != VK_NULL_HANDLE; }

  /// Records commands, submits them and waits for completion. Meant for uploads at load time and for read-back.
  void run_now(const std::function<void(VkCommandBuffer)>& record) const;
  void wait_idle() const;

 private:
  void create_instance(const DeviceOptions& options);
  void choose_physical();
  void create_device();
  void destroy() noexcept;
  static VKAPI_ATTR VkBool32 VKAPI_CALL message(VkDebugUtilsMessageSeverityFlagBitsEXT severity,
                                                VkDebugUtilsMessageTypeFlagsEXT type,
                                                const VkDebugUtilsMessengerCallbackDataEXT* data, void* device);

  VkInstance instance_ = VK_NULL_HANDLE;
  VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
  VkSurfaceKHR surface_ = VK_NULL_HANDLE;
  VkPhysicalDevice physical_ = VK_NULL_HANDLE;
  VkDevice device_ = VK_NULL_HANDLE;
  VkQueue queue_ = VK_NULL_HANDLE;
  VkCommandPool pool_ = VK_NULL_HANDLE;
  std::uint32_t queue_family_ = 0;
  std::string name_;
  VkPhysicalDeviceLimits limits_{};
  bool is_software_ = false;
  float max_anisotropy_ = 1.0f;
  float max_point_size_ = 1.0f;
  std::uint32_t timestamp_bits_ = 0;
  std::unique_ptr<Memory> memory_;
  std::unique_ptr<PipelineCache> pipeline_cache_;
  std::function<void(std::string_view)> on_message_;
  std::atomic<std::uint64_t> messages_{0}, numbers_{0};
};

}  // namespace sinew::viewer
