// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "runtime/base/api.h"
#include "runtime/base/result.h"
#include "runtime/graph/graph_definition.h"
#include "runtime/sync/sync_track.h"

namespace sinew {

/// Where an event of a clip lies in the common cycle of its blend space.
struct SpaceEvent {
  std::int64_t position = 0;  ///< [0, kPhasePeriod)
  std::uint32_t index = 0;    ///< of the clip's event
};

/// A clip as a blend space takes it: its events' phases, rising in [0, 1], and its beats.
struct SpaceClip {
  std::span<const double> event_phases;
  SyncTrack track;
};

/// How the clips of each blend space of a graph play in step. The common cycle of a space has segments of equal length
/// in phase; segment k of a clip lasts from its beat k to its beat k + 1. So a place in the common cycle is a place in
/// the cycle of each clip, by a piecewise linear map. Internal to graph/.
/// eq   own phase = b(k) + s (b(k + 1) - b(k)) for the place (k + s) / segments, not wrapped
class SINEW_API SpaceBeats {
 public:
  /// Aligns the beats of each space's clips by name. If all names then agree, the segments are the least common
  /// multiple of the numbers of beats. Else only the longest sequence of beats that all clips share is kept
  /// (find_common_beats). Clips without beats play once in a common cycle. A space without common beats stays without
  /// segments.
  /// in   clips  [points], mirrored where the point's node is
  /// err  too_large (more than kMostGraphSegments segments)
  static Result<SpaceBeats> make(const GraphTables& tables, std::span<const SpaceClip> clips);

  /// Segments of the common cycle; 0: the clips share one phase.
  std::uint32_t segments(GraphIndex space) const noexcept {
    return space < spaces_.size() ? spaces_[space].segments : 0;
  }
  /// The beats of the common cycle. Their names are those of the first clip that has beats.
  SyncTrack track(GraphIndex space) const noexcept {
    if (segments(space) == 0) return {};
    return {std::span(beats_).subspan(spaces_[space].first_beat, spaces_[space].segments)};
  }
  /// [segments + 1] own phases of a point's clip at the boundaries of segments.
  const double* bounds(std::size_t point) const noexcept { return bounds_.data() + points_[point].first_bound; }
  /// Rounds of a point's clip in the common cycle.
  double rounds(std::size_t point) const noexcept { return points_[point].rounds; }
  std::span<const SpaceEvent> events(std::size_t point) const noexcept {
    return std::span(events_).subspan(points_[point].first_event, points_[point].event_count);
  }

 private:
  struct Space {
    std::uint32_t segments = 0, first_beat = 0;
  };
  struct Point {
    std::uint32_t first_bound = 0, first_event = 0, event_count = 0;
    double rounds = 1.0;
  };

  ErrorCode add_space(const GraphBlendSpace& space, std::span<const SpaceClip> clips);
  void add_point(std::size_t point, const SpaceClip& clip, std::span<const double> bounds);

  std::vector<Space> spaces_;
  std::vector<Point> points_;
  std::vector<double> bounds_;
  std::vector<SpaceEvent> events_;
  std::vector<SyncBeat> beats_;
};

/// Limits the pieces into which a step is cut.
inline constexpr std::uint32_t kMostGraphSegments = 64;

}  // namespace sinew
