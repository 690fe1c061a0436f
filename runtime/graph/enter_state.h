// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/graph/live_graph.h"
#include "runtime/graph/next_moment.h"

namespace sinew {

/// Starts a node, and all nodes below it that play from the start.
/// in   base  start of the memory to which the node's offset is relative.     Internal to graph/.
void start_node(const LiveGraph& live, GraphIndex node, std::byte* base) noexcept;

/// Starts the newly chosen child of each select whose choice has changed. A state that a cut has frozen keeps its
/// choice.
/// out  true: something started, so the live lists must be made again
bool follow_choices(const LiveGraph& live, GraphIndex node, std::byte* base) noexcept;

/// Enters the target state of the transition and lets the previous state fade. If the machine has no room for another
/// fade, it drops the state with the smallest weight. Afterwards the live lists must be made again.
/// out  triggers  bits of the triggers that the transition used are added
void take_transition(const LiveGraph& live, const LiveMachine& machine, const NextTransition& next,
                     std::uint64_t& triggers) noexcept;

/// Ends fades whose time is over, and leaves the states that they have faded out.
/// out  true: a state was left, so the live lists must be made again
bool end_fades(const LiveGraph& live, const LiveMachine& machine) noexcept;

}  // namespace sinew
