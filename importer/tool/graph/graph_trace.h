// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "importer/tool/graph/graph_files.h"
#include "importer/tool/json.h"

namespace sinew::tool {

/// A script: settings of parameters at times, and how long and fine the graph is played.
struct GraphScript {
  struct Setting {
    double time_s = 0.0;
    GraphIndex parameter = 0;
    float value = 0.0f;
  };
  std::vector<Setting> settings;  ///< in the order of time
  double duration_s = 5.0, fps = 30.0;
};

/// Reads `NAME=VALUE@TIME`; "@TIME" may lack, then it is 0. A trigger takes any value but 0.
/// err  a sentence
tl::expected<std::vector<GraphScript::Setting>, std::string> read_settings(const std::vector<std::string>& texts,
                                                                           const GraphDefinition& graph);

/// Plays a graph and tells each frame: time, states with their weights and times, program, events. `hash` is that of
/// the frames' text, so a golden test needs to keep no more.
Json trace_graph(const GraphOfModel& model, const GraphScript& script);

/// The same as a table: a line a frame, and the hash below it.
std::string trace_text(const Json& trace);

}  // namespace sinew::tool
