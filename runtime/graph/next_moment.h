// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/graph/graph_time.h"
#include "runtime/graph/live_graph.h"

namespace sinew {

/// The transition that a machine takes next if its parameters stay as they are.
struct NextTransition {
  GraphTicks in = kNever;                 ///< ticks from now
  GraphIndex transition = kNoGraphIndex;  ///< none: request_state asked for a state that no transition leads to
  GraphIndex from = kNoGraphIndex;        ///< state of the machine that it leaves
  GraphIndex to = kNoGraphIndex;
};

/// A state that a transition has entered stays for this long at least, so that an update has a bounded number of
/// transitions: 1,000 a second.
inline constexpr GraphTicks kShortestStay = kTicksPerSecond / 1000;

/// Finds it by the rules of graph_machine.h.
/// in   horizon  transitions that are later than this are not looked for, and answer kNever
/// cost O(transitions of the states that may be left)
NextTransition next_transition(const LiveGraph& live, std::span<const LiveMotion> motions, const LiveMachine& machine,
                               GraphTicks horizon) noexcept;

/// True if the condition, of parameters alone, holds; those of time do not.
bool holds_now(const LiveGraph& live, const GraphCondition& condition) noexcept;

/// Ticks until the oldest fade that is still going ends; kNever without a fade. Internal to graph/.
GraphTicks next_fade_end(const LiveGraph& live, const LiveMachine& machine) noexcept;

}  // namespace sinew
