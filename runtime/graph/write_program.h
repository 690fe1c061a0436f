// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/graph/live_graph.h"
#include "runtime/pose_program/pose_program.h"

namespace sinew {

/// Writes the pose program of the nodes that play now. Fading states and points of blend spaces become operands of a
/// single mean, weighted by the product of their weights. Poses of weight 0 are left out. Internal to graph/.
void write_program(LiveGraph& live, PoseProgram& program) noexcept;

}  // namespace sinew
