// SPDX-License-Identifier: MIT
#pragma once
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

  /// Clip time of a sample at a position within [0, period].
  double time_s(const LiveSample& sample, std::int64_t position) const noexcept;
  /// Place of a sample at any position of a motion that loops.
  ClipPlace place_of(const LiveSample& sample, std::int64_t position) const noexcept;
  /// The segment in which the motion moves on. At a boundary, a motion that moves backwards is in the segment before
  /// it.
  std::uint64_t segment(bool backwards) const noexcept;
  /// Ticks until the motion leaves its segment; kNever without segments.
  GraphTicks to_segment_end(bool backwards) const noexcept;
  /// Position `ahead` ticks from now; negative looks back.
  std::int64_t position_at(GraphTicks ahead) const noexcept;
};

}  // namespace sinew
