// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "viewer/device/device.h"

namespace sinew::viewer {

/// GPU times of the parts of one frame: marks are written between them. Does nothing on a queue without timestamps.
class Timestamps {
 public:
  Timestamps(const Device& device, std::uint32_t max_marks);
  ~Timestamps();
  Timestamps(const Timestamps&) = delete;
  Timestamps& operator=(const Timestamps&) = delete;

  void begin(VkCommandBuffer commands);  ///< outside of rendering; forgets the old marks and makes the first
  void mark(VkCommandBuffer commands);

  /// Milliseconds between neighbouring marks; the GPU must be done with the frame. One value less than marks.
  std::vector<double> milliseconds() const;

 private:
  const Device& device_;
  VkQueryPool pool_ = VK_NULL_HANDLE;
  std::uint32_t max_marks_, marks_ = 0;
};

}  // namespace sinew::viewer
