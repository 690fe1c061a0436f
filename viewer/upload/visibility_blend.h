// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/model/vertex_visibility.h"

namespace sinew::viewer {

/// The two key poses around a frame's time, and the blend factor.
struct VisibilityBlend {
  std::uint32_t pose = 0, next = 0;
  float factor = 0.0f;  ///< 0 = `pose`, 1 = `next`

  friend bool operator==(const VisibilityBlend&, const VisibilityBlend&) = default;
};

/// Finds the key poses around a time. Times outside the range are clamped. For a clip other than the baked one, returns
/// the first pose.
VisibilityBlend visibility_blend(const VertexVisibility& visibility, std::uint32_t clip, double time_s) noexcept;

}  // namespace sinew::viewer
