// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/graph/live_graph.h"
#include "runtime/sync/sync_group.h"

namespace sinew {

/// Place of the main motion of a state that a transition leaves. Internal to graph/.
struct SyncSource {
  SyncTrack track;
  CyclePlace place;
  bool moves = false;      ///< false: the state has no main motion, or its clip has no length
  bool backwards = false;  ///< the motion plays backwards
};

/// in   node, base  of the state, before the transition changes the slots
SyncSource find_sync_source(const LiveGraph& live, GraphIndex node, std::byte* base) noexcept;

/// Moves the main motion of a node that has just started to the place that follows from the source. The events at that
/// place are reported for the source only.
void start_in_sync(const LiveGraph& live, GraphIndex node, std::byte* base, const SyncSource& source,
                   SyncStart rule) noexcept;

}  // namespace sinew
