// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "runtime/base/index.h"

namespace sinew::viewer {

/// Ambient access that was baked at vertices, for one pose or for key poses of a clip.
struct VertexAccess {
  std::vector<double> times_s = {0.0};  ///< [P] rising, of the key poses
  std::uint32_t clip = kNone;           ///< the clip of the key poses; with one pose it does not matter
  /// [mesh][primitive][P * V] pose after pose, in [0, 1]; empty = all light arrives
  std::vector<std::vector<std::vector<float>>> values;
};

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
