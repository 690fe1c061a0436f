// SPDX-License-Identifier: MIT
#include "importer/graph/graph_beats.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <optional>

#include "runtime/animation/truth_pose.h"

namespace sinew {
namespace {

constexpr std::size_t kSamples = 512;
constexpr double kOneBeat = 0.001;   // of a clip
constexpr double kLeastLift = 0.01;  // of the height of the rest pose

double height_of(const Affined& model) noexcept { return translation_of(model).y; }

double height_of_rest(const Skeleton& skeleton) {
  TruthPose pose;
  evaluate_truth(Animation{}, skeleton, 0.0, pose);
  double lowest = 0.0, highest = 0.0;
  for (const Affined& model : pose.model) {
    lowest = std::min(lowest, height_of(model));
    highest = std::max(highest, height_of(model));
  }
  return highest - lowest;
}

std::vector<double> touchdowns_of(const Animation& clip, const Skeleton& skeleton, std::uint32_t foot) {
  std::vector<double> heights;
  TruthPose pose;
  const auto duration_s = static_cast<double>(clip.duration_s);
  for (std::size_t i = 0; i < kSamples; ++i) {
    evaluate_truth(clip, skeleton, duration_s * static_cast<double>(i) / static_cast<double>(kSamples), pose);
    heights.push_back(height_of(pose.model[foot]));
  }
  return find_touchdowns(heights, kLeastLift * height_of_rest(skeleton));
}

}  // namespace

std::vector<double> find_touchdowns(std::span<const double> heights, double least_lift) {
  std::vector<double> phases;
  if (heights.empty()) return phases;
  const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
  const double range = *high - *low, ground = *low + 0.1 * range, air = *low + 0.3 * range;
  if (!(range > 0.0 && range >= least_lift)) return phases;
  const std::size_t count = heights.size(), top = static_cast<std::size_t>(high - heights.begin());
  bool was_in_air = true;
  for (std::size_t i = top; i < top + count; ++i) {
    const double from = heights[i % count], to = heights[(i + 1) % count];
    was_in_air |= from > air;
    if (!was_in_air || from <= ground || to > ground) continue;
    const double phase = (static_cast<double>(i) + (from - ground) / (from - to)) / static_cast<double>(count);
    phases.push_back(phase - std::floor(phase));
    was_in_air = false;
  }
  std::sort(phases.begin(), phases.end());
  return phases;
}

std::vector<SyncBeat> find_beats(const GraphDocument& document, const Animation& clip, const Skeleton& skeleton) {
  std::vector<SyncBeat> all;
  const auto duration_s = static_cast<double>(clip.duration_s);
  if (!(duration_s > 0.0)) return all;
  std::uint32_t index = 0;
  for (const auto& [name, beat] : document.beats) {
    const std::string& event = beat.event.empty() ? name : beat.event;
    const std::size_t before = all.size();
    for (std::size_t e = 0; e < clip.annotations.event_names.size(); ++e) {
      if (clip.annotations.event_names[e] != event) continue;
      const double phase = clip.annotations.event_times_s[e] / duration_s;
      all.push_back({phase < 1.0 ? phase : 0.0, index});
    }
    const auto foot = beat.foot.empty() ? std::nullopt : skeleton.find(beat.foot);
    if (all.size() == before && foot)
      for (const double phase : touchdowns_of(clip, skeleton, *foot)) all.push_back({phase, index});
    ++index;
  }
  std::stable_sort(all.begin(), all.end(), [](const SyncBeat& a, const SyncBeat& b) { return a.phase < b.phase; });
  std::vector<SyncBeat> beats;
  for (const SyncBeat& beat : all)
    if (beats.empty() || beat.phase - beats.back().phase >= kOneBeat) beats.push_back(beat);
  return beats;
}

std::vector<std::uint32_t> mirrored_beats(const GraphDocument& document) {
  std::vector<std::uint32_t> mirrored;
  for (const auto& [name, beat] : document.beats) {
    const auto other = beat.mirror.empty() ? document.beats.find(name) : document.beats.find(beat.mirror);
    mirrored.push_back(static_cast<std::uint32_t>(std::distance(document.beats.begin(), other)));
  }
  return mirrored;
}

}  // namespace sinew
