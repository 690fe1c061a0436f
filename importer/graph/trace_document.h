// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "importer/graph/graph_text.h"

namespace sinew {

/// A golden trace: how a graph is played, and what each frame was then. trace_schema.h lists the JSON keys.
struct TraceDocument {
  std::string graph;  ///< file, relative to that of the trace
  std::string variation;
  std::vector<std::string> set;  ///< NAME=VALUE@SECONDS
  double duration_s = 5.0, fps = 30.0;
  std::vector<std::string> frames;  ///< one line each: time, states, program, events
};

/// Reads the text of a golden trace.
/// err  as read_graph
GraphTextResult<TraceDocument> read_trace(std::string_view text);

}  // namespace sinew
