// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include <tl/expected.hpp>

#include "runtime/base/api.h"
#include "runtime/base/result.h"
#include "runtime/graph/graph_definition.h"
#include "runtime/graph/space_beats.h"
#include "runtime/playback/root_track.h"

namespace sinew {

/// The clip that a character plays for one of its graph's clip names.
struct GraphClip {
  std::uint32_t clip = 0;                      ///< index of the clip in the plan, for PoseOp::index
  double duration_s = 0.0;                     ///< 0 to kMostGraphClip_s
  std::span<const double> event_times_s = {};  ///< never decreasing, in [0, duration]
  const RootTrack* root = nullptr;             ///< null: the clip does not move the character.
  /// Beats by which blend spaces and transitions keep motions in step, such as the feet that touch the ground.
  /// Phases increase; equal names are the same foot.
  std::span<const SyncBeat> beats = {};
  bool root_in_pose = true;  ///< false: the pose plays on the spot (bake_out_root), and the root track moves it
};
inline constexpr double kMostGraphClip_s = 6000.0;

/// Clips for the clip names of a graph. Characters that use the same rules with different motions share a graph, and
/// each kind has its own set. Immutable.
/// owns  everything but the root tracks, which must outlive it
class SINEW_API GraphClipSet {
 public:
  /// A clip with its times in whole ticks.
  struct Entry {
    std::int64_t period = 0;  ///< length, in the unit of MotionState::position for clips
    double duration_s = 0.0;  ///< rounded to whole ticks
    std::uint32_t first_event = 0, event_count = 0;
    std::uint32_t first_beat = 0, beat_count = 0;
    const RootTrack* root = nullptr;
    std::uint32_t clip = 0;
    bool root_in_pose = true;
  };

  /// in   clips[clip names of the graph];   mirror_normal  normal of the plane that mirrors root motion
  ///      (MirrorMap::plane_normal)
  /// err  not_finite, too_large (a duration), times_not_increasing (event times or beats decrease or lie outside the
  ///      clip)
  static Result<GraphClipSet> make(std::span<const GraphClip> clips, const Vec3<double>& mirror_normal = {1, 0, 0});

  /// Same, and the clips of each blend space play in step by their beats. Without it they share one phase.
  /// in   mirrored_beats  [names of beats] the mirrored name of each, for clips that play mirrored; empty = the same
  /// err  also size_mismatch (fewer clips than names), index_out_of_range (mirrored_beats lacks a name), too_large (a
  ///      space has a common cycle of more than 64 beats)
  static Result<GraphClipSet> make(const GraphDefinition& graph, std::span<const GraphClip> clips,
                                   std::span<const std::uint32_t> mirrored_beats = {},
                                   const Vec3<double>& mirror_normal = {1, 0, 0});

  std::span<const Entry> entries() const noexcept { return entries_; }
  std::span<const std::int64_t> events_of(const Entry& entry) const noexcept {  ///< position units
    return std::span(events_).subspan(entry.first_event, entry.event_count);
  }
  bool any_root() const noexcept { return any_root_; }
  /// True if the pose of some clip contains the motion of its root track.
  bool any_root_in_pose() const noexcept { return any_root_in_pose_; }
  const SpaceBeats& space_beats() const noexcept { return space_beats_; }
  /// The beats of a clip, for a cycle of a length above 0.
  SyncTrack track_of(const Entry& entry, bool mirrored, double length_s) const noexcept {
    return {std::span(beats_).subspan(entry.first_beat, entry.beat_count), length_s,
            mirrored ? std::span<const std::uint32_t>(mirrored_beats_) : std::span<const std::uint32_t>()};
  }
  const Vec3<double>& mirror_normal() const noexcept { return mirror_normal_; }

 private:
  std::vector<Entry> entries_;
  std::vector<std::int64_t> events_;
  std::vector<SyncBeat> beats_;
  std::vector<std::uint32_t> mirrored_beats_;
  SpaceBeats space_beats_;
  Vec3<double> mirror_normal_{1, 0, 0};
  bool any_root_ = false, any_root_in_pose_ = false;
};

}  // namespace sinew
