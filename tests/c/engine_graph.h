// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/sinew.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { engine_most_parameters = 8, engine_most_events = 16, engine_state_bytes = 4096 };

/// A character that a graph moves, as an engine keeps it: plain memory, which a copy saves.
typedef struct engine_walker {
  union {
    unsigned char bytes[engine_state_bytes];
    double aligned;
  } state;
  float parameters[engine_most_parameters];
  sinew_dual_quat world;
  sinew_pose_op ops[SINEW_MOST_OPS];
  size_t op_count;
  sinew_graph_event events[engine_most_events];
  size_t event_count;
} engine_walker;

sinew_error engine_start_walker(const sinew_graph* graph, const sinew_graph_clips* clips, engine_walker* walker);
sinew_error engine_move_walker(const sinew_graph* graph, const sinew_graph_clips* clips, double dt_s,
                               engine_walker* walker);

#ifdef __cplusplus
}
#endif
