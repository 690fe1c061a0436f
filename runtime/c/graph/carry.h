// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/c/graph/graph.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Continues a character with a changed version of its graph (CarryStateJob): nodes and states of equal names play on.
/// in   from_state  of `from`, not the memory of `state`;   clips, parameters  of `graph`
/// err  as sinew_graph_start, and SINEW_WRONG_PLAN (`from_state` is of another graph). `state` is then untouched
SINEW_API sinew_error sinew_graph_carry(const sinew_graph* from, const void* from_state, size_t from_bytes,
                                        const sinew_graph* graph, const sinew_graph_clips* clips,
                                        const float* parameters, size_t parameter_count, void* state,
                                        size_t state_bytes);

#ifdef __cplusplus
}
#endif
