// SPDX-License-Identifier: MIT
#pragma once
#include "importer/graph/trace_document.h"

// Lists every member of a golden trace, as graph_schema.h does for graphs.
namespace sinew::graph_schema {

inline constexpr int kTraceVersion = 1;

template <class V, class D>
void describe(V& v, D& d, const TraceDocument*) {
  v.required("graph", d.graph, "file of the graph, relative to this one");
  v.optional("variation", d.variation, "of the graph");
  v.optional("set", d.set, "changes of parameters, NAME=VALUE@SECONDS");
  v.required("duration_s", d.duration_s, "seconds that are played");
  v.required("fps", d.fps, "frames a second");
  v.required("frames", d.frames, "a line for each frame");
}

}  // namespace sinew::graph_schema
