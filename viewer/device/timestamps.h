// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "viewer/device/device.h"

namespace sinew::viewer {

/// GPU times of the parts of one frame, measured between marks. Does nothing on a queue without timestamps.
class Timestamps {
 public:
  Timestamps(const Device& device, std::uint32_t max_marks);
  ~Timestamps();
  Timestamps(const Timestamps&) = delete;
  Timestamps& operator=(const Timestamps&) = delete;

  void begin(VkCommandBuffer commands);  ///< outside of rendering; removes the old marks and writes the first
  void mark(VkCommandBuffer commands);

  /// Milliseconds between consecutive marks, one fewer than marks. The GPU must be done with the frame.
  std::vector<double> milliseconds() const;

 private:
  const Device& device_;
  VkQueryPool pool_ = VK_NULL_HANDLE;
  std::uint32_t max_marks_, marks_ = 0;
};

}  // namespace sinew::viewer
