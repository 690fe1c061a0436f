// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/graph/live_graph.h"
#include "runtime/graph/update_graph.h"

namespace sinew {

/// Writes events as long as there is room, and counts the rest. Internal to graph/.
class GraphEventLog {
 public:
  GraphEventLog(std::span<GraphEvent> room, GraphStep& step) noexcept : room_(room), step_(step) {}
  void add(const GraphEvent& event) noexcept {
    if (step_.event_count < room_.size())
      room_[step_.event_count++] = event;
    else
      ++step_.events_left_out;
  }
  void leave_out(std::uint64_t count) noexcept { step_.events_left_out += count; }
  bool is_full() const noexcept { return step_.event_count >= room_.size(); }
  std::size_t count() const noexcept { return step_.event_count; }
  /// Sorts the events from index `first` on by time.
  void sort_from(std::size_t first, bool backwards) noexcept;

 private:
  std::span<GraphEvent> room_;
  GraphStep& step_;
};

/// Moves all motions and logs the events that they pass. An event at the boundary of two pieces belongs to the earlier
/// piece. A motion that has just started also logs an event at its start.
/// in   ticks  not 0; negative plays backwards. |ticks * step| of each motion stays below 2^61
void play_motions(LiveGraph& live, GraphTicks ticks, GraphEventLog& log) noexcept;

/// Longest piece of a step that play_motions accepts: no motion leaves its segment.
/// in   most  ticks.     out  at most `most`
GraphTicks longest_piece(LiveGraph& live, GraphTicks most, bool backwards) noexcept;

}  // namespace sinew
