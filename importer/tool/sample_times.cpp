// SPDX-License-Identifier: MIT
#include "importer/tool/sample_times.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include <fmt/core.h>

namespace sinew::tool {
namespace {

std::vector<float> all_key_times(const Animation& animation) {
  std::vector<float> times;
  const auto add = [&](const auto& track) { times.insert(times.end(), track.times_s.begin(), track.times_s.end()); };
  for (const BoneAnimation& bone : animation.bones) {
    add(bone.translation);
    add(bone.rotation);
    add(bone.scale);
  }
  for (const WeightAnimation& morph : animation.weights) add(morph.weights);
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

void make_increasing(std::vector<double>& times) {
  std::sort(times.begin(), times.end());
  times.erase(std::unique(times.begin(), times.end()), times.end());
}

}  // namespace

tl::expected<std::vector<double>, std::string> parse_times(const std::string& list) {
  std::vector<double> times;
  std::string_view rest = list;
  for (bool more = true; more;) {
    const std::size_t comma = rest.find(',');
    const std::string_view item = rest.substr(0, comma);
    double time_s = 0.0;
    const auto [stop, error] = std::from_chars(item.data(), item.data() + item.size(), time_s);
    if (error != std::errc{} || stop != item.data() + item.size() || !std::isfinite(time_s))
      return tl::unexpected(fmt::format("--times {}: '{}' is not a number of seconds", list, item));
    times.push_back(time_s);
    more = comma != std::string_view::npos;
    if (more) rest.remove_prefix(comma + 1);
  }
  return times;
}

std::vector<double> representative_times(const Animation& animation) {
  const std::vector<float> keys = all_key_times(animation);
  std::vector<double> times = {0.0};
  for (std::size_t quarter = 0; !keys.empty() && quarter <= 4; ++quarter) {
    const std::size_t k = (keys.size() - 1) * quarter / 4;
    times.push_back(keys[k]);
    if (k + 1 < keys.size()) times.push_back(keys[k] + 0.5f * (keys[k + 1] - keys[k]));
  }
  make_increasing(times);
  return times;
}

std::vector<double> frame_times(double duration_s, double fps) {
  std::vector<double> times;
  for (std::size_t i = 0; static_cast<double>(i) / fps < duration_s; ++i) times.push_back(static_cast<double>(i) / fps);
  times.push_back(duration_s);
  return times;
}

}  // namespace sinew::tool
