// SPDX-License-Identifier: MIT
#pragma once
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "runtime/sync/sync_group.h"

namespace sinew::reference {

/// The times at which the segments of a group's common cycle end, by adding up what they take.
inline std::vector<double> segment_ends_s(SyncGroup group) {
  std::int64_t segments = 1;
  for (const SyncMember& member : group)
    segments = std::lcm(segments, std::max<std::int64_t>(1, std::int64_t(member.track.beats.size())));
  std::vector<double> ends;
  double at = 0.0;
  for (std::int64_t k = 0; k < segments; ++k) {
    double sum = 0.0, total = 0.0;
    for (const SyncMember& member : group) {
      const auto& beats = member.track.beats;
      double length = 1.0;
      if (!beats.empty()) {
        const std::size_t b = std::size_t(k + member.first_beat) % beats.size();
        length = (b + 1 < beats.size() ? beats[b + 1].phase : 1.0 + beats[0].phase) - beats[b].phase;
      }
      sum += member.weight * member.track.length_s * length;
      total += member.weight;
    }
    ends.push_back(at += sum / total);
  }
  return ends;
}

/// Beats, with their fraction, that a group has passed after `time_s` from beat 0.
inline double beats_after(SyncGroup group, double time_s) {
  const std::vector<double> ends = segment_ends_s(group);
  const double rounds = std::floor(time_s / ends.back());
  const double left = time_s - rounds * ends.back();
  std::size_t k = 0;
  while (k + 1 < ends.size() && left >= ends[k]) ++k;
  const double start = k == 0 ? 0.0 : ends[k - 1];
  return rounds * double(ends.size()) + double(k) + (left - start) / (ends[k] - start);
}

}  // namespace sinew::reference
