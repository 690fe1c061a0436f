// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "viewer/device/device.h"

namespace sinew::viewer {

/// Measures GPU times between marks within one frame. Does nothing on a queue without timestamps.
class Timestamps {
 public:
  Timestamps(const Device& device, std::uint32_t max_marks);
  ~Timestamps();
  Timestamps(const Timestamps&) = delete;
  Timestamps& operator=(const Timestamps&) = delete;

  /// Resets the queries and writes the first mark; call it outside a render pass.
  void begin(VkCommandBuffer commands);
  void mark(VkCommandBuffer commands);

  /// Milliseconds between consecutive marks: one value less than marks. The GPU must have finished the frame.
  std::vector<double> milliseconds() const;

 private:
  const Device& device_;
  VkQueryPool pool_ = VK_NULL_HANDLE;
  std::uint32_t max_marks_, marks_ = 0;
};

}  // namespace sinew::viewer
