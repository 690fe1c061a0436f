// SPDX-License-Identifier: MIT
#pragma once
#include <memory>

#include "viewer/device/image.h"
#include "viewer/light/environment.h"

namespace sinew::viewer {

/// GPU images for ambient light: the reflection cube map, and the table of split sum and sheen albedo. Both are black
/// until uploaded.
class EnvironmentUpload {
 public:
  explicit EnvironmentUpload(Device& device);
  ~EnvironmentUpload();
  EnvironmentUpload(const EnvironmentUpload&) = delete;
  EnvironmentUpload& operator=(const EnvironmentUpload&) = delete;

  /// Uploads the environment unless it is the current one. Waits for the device before an upload.
  void show(const std::shared_ptr<const Environment>& environment);

  /// Uploads only the table, if missing. Sheen lit by lamps needs it even without an environment.
  void show_table();

  VkDescriptorImageInfo environment() const noexcept;
  VkDescriptorImageInfo split_sum() const noexcept;

 private:
  Device& device_;
  VkSampler sampler_ = VK_NULL_HANDLE;
  GpuImage cube_, table_;
  bool has_table_ = false;
  std::shared_ptr<const Environment> shown_;  ///< kept alive, so that no other environment can have its address
};

}  // namespace sinew::viewer
