// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/graph/live_graph.h"
#include "runtime/math/dual_quaternion.h"

namespace sinew {

/// Length of a cell of the graph's clock. Within a cell, the root motion of several clips has constant velocity.
inline constexpr GraphTicks kRootCell = kTicksPerSecond / 60;

/// Ticks from now to the end of the current cell, in the direction of time.
GraphTicks to_cell_end(GraphTicks now, bool backwards) noexcept;
/// Ticks from now to the middle of the current cell; negative if the middle is in the past.
GraphTicks to_cell_middle(GraphTicks now, bool backwards) noexcept;

/// The motion of the character in a piece of a step. Call it before the motions are moved.
/// eq   one clip: E(from)^-1 E(to) over its rounds.
///      several: exp(f sum w x / sum w). x is the logarithm of a clip's motion over the whole cell, f the fraction of
///      the cell that the piece covers, and w the weights in the middle of the cell. The pieces of a cell multiply to
///      the motion over the cell. States that a transition without a cross-fade has frozen go on with the velocity that
///      they had, with the share that cut_share leaves them.
/// in   ticks  negative plays backwards; with several clips, the piece must not cross the end of a cell
DualQuatd move_root(LiveGraph& live, GraphTicks ticks) noexcept;

/// Root placement that is still contained in the pose: the weighted mean of the clips' root transforms. Internal to
/// graph/.
DualQuatd root_place_now(LiveGraph& live) noexcept;

}  // namespace sinew
