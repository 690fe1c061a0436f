// SPDX-License-Identifier: MIT
#include "viewer/upload/visibility_blend.h"

#include <algorithm>

namespace sinew::viewer {

VisibilityBlend visibility_blend(const VertexVisibility& visibility, std::uint32_t clip, double time_s) noexcept {
  const std::vector<double>& times = visibility.times_s;
  if (times.size() < 2 || clip != visibility.clip) return {};
  const auto after = std::upper_bound(times.begin(), times.end(), time_s);
  if (after == times.begin()) return {};
  const auto pose = static_cast<std::uint32_t>(after - times.begin() - 1);
  if (after == times.end()) return {pose, pose, 0.0f};
  return {pose, pose + 1, static_cast<float>((time_s - times[pose]) / (times[pose + 1] - times[pose]))};
}

}  // namespace sinew::viewer
