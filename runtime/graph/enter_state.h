// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/graph/live_graph.h"
#include "runtime/graph/next_moment.h"

namespace sinew {

/// Starts a node and all below it that plays from the start.
/// in   base  the memory in which the node lies.     Internal to graph/.
void start_node(const LiveGraph& live, GraphIndex node, std::byte* base) noexcept;

/// Starts the children of selects whose choice has changed.
/// out  true: the live lists no longer stand
bool follow_choices(const LiveGraph& live, GraphIndex node, std::byte* base) noexcept;

/// Enters the state and lets the one before fade. A machine without room for another fade forgets the state that weighs
/// least.
/// out  triggers  those that the transition has used.   The live lists no longer stand.
void take_transition(const LiveGraph& live, const LiveMachine& machine, const NextTransition& next,
                     std::uint64_t& triggers) noexcept;

/// Ends fades whose time is over, and leaves the states below them.
/// out  true: the live lists no longer stand
bool end_fades(const LiveGraph& live, const LiveMachine& machine) noexcept;

}  // namespace sinew
