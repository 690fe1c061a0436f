// SPDX-License-Identifier: MIT
#include "runtime/retarget/dense_times.h"

#include <algorithm>
#include <cmath>

namespace sinew {

std::vector<double> dense_times(std::vector<double> keys) {
  constexpr double kStep = 1.0 / 60.0;
  std::sort(keys.begin(), keys.end());
  keys.erase(std::unique(keys.begin(), keys.end()), keys.end());
  std::vector<double> times;
  for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
    const double length = keys[i + 1] - keys[i];
    const auto parts = static_cast<std::size_t>(std::max(1.0, std::ceil(length / kStep - 1e-6)));
    for (std::size_t p = 0; p < parts; ++p)
      times.push_back(keys[i] + length * static_cast<double>(p) / static_cast<double>(parts));
  }
  times.push_back(keys.back());
  return times;
}

std::vector<double> dense_times(const Animation& animation) {
  std::vector<double> keys = {0.0, animation.duration_s};
  for (const BoneAnimation& bone : animation.bones)
    for (const std::vector<float>* times : {&bone.translation.times_s, &bone.rotation.times_s, &bone.scale.times_s})
      keys.insert(keys.end(), times->begin(), times->end());
  return dense_times(std::move(keys));
}

}  // namespace sinew
