// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/model/vertex_access.h"

namespace sinew::viewer {

/// The two key poses that a frame lies between.
struct AccessBlend {
  std::uint32_t pose = 0, next = 0;
  float factor = 0.0f;  ///< 0 = `pose`, 1 = `next`

  friend bool operator==(const AccessBlend&, const AccessBlend&) = default;
};

/// The key poses around a time, and where it lies between them. Before the first and after the last it is that one; of
/// another clip than theirs it is the first.
AccessBlend access_blend(const VertexAccess& access, std::uint32_t clip, double time_s) noexcept;

}  // namespace sinew::viewer
