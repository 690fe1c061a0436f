// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/graph/live_graph.h"
#include "runtime/math/dual_quaternion.h"

namespace sinew {

/// Root motion of several clips is held for cells of this length on the graph's clock.
inline constexpr GraphTicks kRootCell = kTicksPerSecond / 60;

/// Ticks from now to the end of the cell that time runs through.
GraphTicks to_cell_end(GraphTicks now, bool backwards) noexcept;
/// Ticks from now to the middle of that cell; negative if it lies behind.
GraphTicks to_cell_middle(GraphTicks now, bool backwards) noexcept;

/// The motion of the character in a piece of a step. Motions have not moved yet.
/// eq   one clip: E(from)^-1 E(to) over its rounds.
///      several: exp(f sum w x / sum w), x the logarithm of a clip's motion over the whole cell, f the part of the cell
///      that the piece covers, w the weights in the cell's middle. Pieces of a cell multiply to the motion over it.
/// in   ticks  negative plays backwards; with several clips the piece lies in one cell
DualQuatd move_root(LiveGraph& live, GraphTicks ticks) noexcept;

/// The place of the character that the pose still has: the weighted mean of the clips' places. Internal to graph/.
DualQuatd root_place_now(LiveGraph& live) noexcept;

}  // namespace sinew
