// SPDX-License-Identifier: MIT
#pragma once
#include <memory>

#include "viewer/device/image.h"
#include "viewer/light/environment.h"

namespace sinew::viewer {

/// The images of the ambient light: what is reflected from an environment, and the table of the split sum and of sheen.
/// Until they are asked for, they are black.
class EnvironmentUpload {
 public:
  explicit EnvironmentUpload(Device& device);
  ~EnvironmentUpload();
  EnvironmentUpload(const EnvironmentUpload&) = delete;
  EnvironmentUpload& operator=(const EnvironmentUpload&) = delete;

  /// Uploads the environment, unless it is the one that is shown; waits for the device then.
  void show(const std::shared_ptr<const Environment>& environment);

  /// Uploads the table alone, unless it is there: lamps on sheen need it without an environment, too.
  void show_table();

  VkDescriptorImageInfo environment() const noexcept;
  VkDescriptorImageInfo split_sum() const noexcept;

 private:
  Device& device_;
  VkSampler sampler_ = VK_NULL_HANDLE;
  GpuImage cube_, table_;
  bool has_table_ = false;
  std::shared_ptr<const Environment> shown_;  ///< kept, so that no other environment has its address
};

}  // namespace sinew::viewer
