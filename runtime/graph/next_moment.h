// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/graph/graph_time.h"
#include "runtime/graph/live_graph.h"

namespace sinew {

/// The next transition of a machine, if its parameters stay as they are.
struct NextTransition {
  GraphTicks in = kNever;                 ///< ticks from now
  GraphIndex transition = kNoGraphIndex;  ///< kNoGraphIndex: request_state without a transition to that state
  GraphIndex from = kNoGraphIndex;        ///< index of the state that it leaves
  GraphIndex to = kNoGraphIndex;
};

/// Shortest time between entering and leaving a state. It limits an update to 1,000 transitions per second and machine.
inline constexpr GraphTicks kShortestStay = kTicksPerSecond / 1000;

/// Finds the next transition by the rules of graph_machine.h.
/// in   horizon  ticks from now. If the next transition is later, the result is kNever
/// cost O(transitions of the states that may be left)
NextTransition next_transition(const LiveGraph& live, std::span<const LiveMotion> motions, const LiveMachine& machine,
                               GraphTicks horizon) noexcept;

/// True if a condition on parameters holds. Conditions on time give false.
bool holds_now(const LiveGraph& live, const GraphCondition& condition) noexcept;

/// Ticks until the next fade ends; kNever without a fade. Internal to graph/.
GraphTicks next_fade_end(const LiveGraph& live, const LiveMachine& machine) noexcept;

}  // namespace sinew
