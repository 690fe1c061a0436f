// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "runtime/graph/graph_clips.h"
#include "runtime/graph/graph_time.h"
#include "runtime/graph/state_blocks.h"

namespace sinew {

/// A clip of a motion that plays, with its share in the motion.
struct LiveSample {
  const GraphClipSet::Entry* entry;
  const double* bounds;  ///< of a blend space with segments: SpaceBeats::bounds; else null
  double length;         ///< ticks of a round of the clip; 0: it stands still
  float share;
  GraphIndex name;   ///< index of its clip name in the graph
  GraphIndex point;  ///< point of the blend space
  bool mirror;
};

/// A place in the rounds of a clip, for any position of its motion.
struct ClipPlace {
  double turns, time_s;
};

/// A motion: a clip node or a blend space that plays.
struct LiveMotion {
  MotionState* state;
  std::int64_t period;    ///< period of state->position; 0: the motion stands still
  std::int64_t step;      ///< change of position per tick
  std::int64_t own_step;  ///< the same without synchronisation
  double length;          ///< ticks of a round without synchronisation; 0: the motion stands still
  std::uint16_t first_sample, sample_count;
  std::uint16_t segments;  ///< of a blend space whose clips play in step by beats; else 0
  GraphIndex node;
  bool loop, is_space;
  bool moves_root;            ///< false: its layer does not contribute to root motion
  float weight, root_weight;  ///< shares of its pose and its root motion in those of the graph, from the last weigh()

  /// A position within [0, period] for time_s.
  struct Place {
    double round;         ///< positions of clips: ticks of the clip
    std::size_t segment;  ///< of a blend space with segments
    double rest;          ///< share of the segment that has passed
  };
  Place place_at(std::int64_t position) const noexcept {
    if (!is_space) return {static_cast<double>(position) * kTicksOfClip, 0, 0.0};
    const double round = static_cast<double>(position) * kRoundsOfPhase, scaled = round * segments;
    if (segments == 0) return {round, 0, 0.0};
    const std::size_t k = std::min<std::size_t>(static_cast<std::size_t>(scaled), segments - 1u);
    return {round, k, scaled - static_cast<double>(k)};
  }
  /// Clip time of a sample.
  double time_s(const LiveSample& sample, const Place& place) const noexcept {
    if (!is_space) return place.round / static_cast<double>(kTicksPerSecond);
    const double phase = own_phase(sample, place);
    return (sample.bounds == nullptr ? phase : phase - whole_below(phase)) * sample.entry->duration_s;
  }
  double time_s(const LiveSample& sample, std::int64_t position) const noexcept {
    return time_s(sample, place_at(position));
  }
  /// Place of a sample at any position of a motion that loops.
  ClipPlace place_of(const LiveSample& sample, std::int64_t position) const noexcept;
  /// The segment in which the motion moves on. At a boundary, a motion that moves backwards is in the segment before
  /// it.
  std::uint64_t segment(bool backwards) const noexcept;
  /// Way in positions until the motion leaves its segment; kNever without segments.
  std::int64_t to_segment_end(bool backwards) const noexcept;
  /// Position `ahead` ticks from now; negative looks back.
  std::int64_t position_at(GraphTicks ahead) const noexcept;

 private:
  /// Phase of a sample's clip in a blend space, not wrapped.
  static double own_phase(const LiveSample& sample, const Place& place) noexcept {
    if (sample.bounds == nullptr) return place.round;
    const double* const bounds = sample.bounds + place.segment;
    return bounds[0] + place.rest * (bounds[1] - bounds[0]);
  }
};

}  // namespace sinew
