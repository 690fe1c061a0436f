// SPDX-License-Identifier: MIT
#include "tests/c/engine_graph.h"

#include <string.h>

sinew_error engine_start_walker(const sinew_graph* graph, const sinew_graph_clips* clips, engine_walker* walker) {
  sinew_graph_info info;
  uint32_t p;
  sinew_error error;
  memset(walker, 0, sizeof *walker);
  walker->world = sinew_dual_quat_identity();
  info.struct_size = sizeof info;
  error = sinew_graph_get_info(graph, &info);
  if (error != SINEW_OK) return error;
  if (info.state_bytes > engine_state_bytes || info.parameters > engine_most_parameters) return SINEW_TOO_LARGE;
  for (p = 0; p < info.parameters; ++p) walker->parameters[p] = sinew_graph_initial(graph, p);
  return sinew_graph_start(graph, clips, walker->parameters, engine_most_parameters, walker->state.bytes,
                           engine_state_bytes);
}

sinew_error engine_move_walker(const sinew_graph* graph, const sinew_graph_clips* clips, double dt_s,
                               engine_walker* walker) {
  sinew_graph_step step;
  sinew_error error;
  memset(&step, 0, sizeof step);
  step.struct_size = sizeof step;
  step.ops = walker->ops;
  step.events = walker->events;
  step.event_room = engine_most_events;
  error = sinew_graph_update(graph, clips, walker->parameters, engine_most_parameters, walker->state.bytes,
                             engine_state_bytes, dt_s, &step);
  if (error != SINEW_OK) return error;
  walker->op_count = step.op_count;
  walker->event_count = step.event_count;
  walker->world = sinew_dual_quat_product(&walker->world, &step.root_motion);
  return SINEW_OK;
}
