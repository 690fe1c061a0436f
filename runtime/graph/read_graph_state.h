// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>

#include "runtime/base/api.h"
#include "runtime/graph/graph_clips.h"
#include "runtime/graph/graph_definition.h"

namespace sinew {

/// A state of a machine that plays, for debuggers, traces and pictures.
struct GraphStateView {
  GraphIndex node = 0;   ///< node of the machine
  GraphIndex state = 0;  ///< index within the machine
  float weight = 0.0f;   ///< share in the mix of the machine's states
  double time_s = 0.0;   ///< time since the state was entered
  double rounds = 0.0;   ///< rounds that its main clip has played; 0 if it has none
  bool active = false;   ///< false: it fades out
};

/// Lists the states that play: machines from the root down, states of a machine from the oldest to the active one.
/// in   state  of this graph, after a start or an update
/// out  number of states that play; if `views` is too short, later states are counted but not written
/// cost O(what plays), no allocation
SINEW_API std::size_t read_graph_state(const GraphDefinition& graph, const GraphClipSet& clips,
                                       std::span<const float> parameters, std::span<const std::byte> state,
                                       std::span<GraphStateView> views) noexcept;

}  // namespace sinew
