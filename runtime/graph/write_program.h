// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/graph/live_graph.h"
#include "runtime/pose_program/pose_program.h"

namespace sinew {

/// Writes the program of what plays now. States that fade and points of blend spaces are operands of one mean, with
/// products of their weights. Poses of weight 0 are left out. Internal to graph/.
void write_program(LiveGraph& live, PoseProgram& program) noexcept;

}  // namespace sinew
