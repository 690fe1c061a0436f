// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "runtime/base/api.h"
#include "runtime/playback/event_cursor.h"

namespace sinew {

/// A clip that plays together with others: its step, its events, and its weight before and after the step. A clip that
/// several operations of a program sample by one clock plays once, with the sum of their shares (find_op_shares).
/// owns  nothing
struct PlayingClip {
  PlaybackStep step;
  std::span<const double> event_times_s;  ///< as EventCursor takes them
  double step_s = 0.0;                    ///< length of the step in clip time: speed * dt. A clip that stops at its end
                                          ///< plays less of it
  float weight_before = 0.0f;             ///< in the pose of the frame before; 0 = the clip has just begun
  float weight_after = 0.0f;              ///< in the pose of this frame; 0 = the clip has just been faded out
};

/// An event that a step of several clips crosses.
struct BlendedEvent {
  std::size_t clip = 0;   ///< index into the clips that play
  std::size_t event = 0;  ///< index of the clip's event
  double moment = 1.0;    ///< [0, 1] part of the step that has passed
  float weight = 0.0f;    ///< of the clip at that moment
};

/// Iterates over the events of all clips that play in one step, in the order of time, each once per crossing:
///     for (BlendedEvents crossed(playing, cursors); auto e = crossed.next();)
///       if (e->weight > 0.25f) fire(*e);
/// Pass the clips of this frame's program and of the previous one, so that the last step of a faded clip counts.
/// eq   u = clip time played until the event / |step_s|, weight = (1 - u) weight_before + u weight_after; u = 1 in a
///      step of length 0. Of events at the same moment, those of the first clip come first
/// in   playing    a step with an error, and a clip whose weights are both 0, has no events
///      cursors[playing]   memory of the iteration, overwritten.     cost O(clips) an event, and EventCursor's
class SINEW_API BlendedEvents {
 public:
  struct Cursor {
    std::optional<EventCursor> crossed;
    BlendedEvent next;
    bool has_next = false;
  };

  BlendedEvents(std::span<const PlayingClip> playing, std::span<Cursor> cursors) noexcept;

  std::optional<BlendedEvent> next() noexcept;
  /// Number of whole rounds whose events next() skips, summed over the clips (EventCursor::rounds_left_out).
  std::uint64_t rounds_left_out() const noexcept { return rounds_left_out_; }

 private:
  void advance(std::size_t clip) noexcept;

  std::span<const PlayingClip> playing_;
  std::span<Cursor> cursors_;
  std::uint64_t rounds_left_out_ = 0;
};

}  // namespace sinew
