// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <span>

#include "runtime/base/api.h"
#include "runtime/base/run_job.h"
#include "runtime/graph/graph_clips.h"
#include "runtime/graph/graph_definition.h"

namespace sinew {

/// Continues a character with a changed version of its graph, for example after its file was edited. Names identify
/// what stays. A node plays on if the new graph has a node of its name and kind in its place, and a clip also needs the
/// same clip name. A machine keeps its states, their times and their fades by the names of states. All else starts
/// anew, as StartGraphJob starts it:
/// - a machine whose active state is gone; a select whose playing child is gone;
/// - a fade whose transition is gone, or is of another kind, ends at once.
/// Triggers that are set, and a state that was requested, stay if their names do. The clock of the graph goes on.
/// in   from_state  of `from`;   clips, parameters  of the new graph;   state  8-byte aligned, not that of `from_state`
/// err  size_mismatch, not_finite, wrong_plan (a state of another graph)
/// cost O(states that play * (states + transitions)), no allocation
struct CarryStateJob {
  const GraphDefinition* from = nullptr;
  std::span<const std::byte> from_state;
  const GraphDefinition* graph = nullptr;
  const GraphClipSet* clips = nullptr;
  std::span<const float> parameters;
  std::span<std::byte> state;
};
SINEW_API ErrorCode check(const CarryStateJob& job) noexcept;
SINEW_API void run_unchecked(const CarryStateJob& job) noexcept;

}  // namespace sinew
