// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "importer/tool/graph/graph_files.h"
#include "importer/tool/json.h"

namespace sinew::tool {

/// A script for playing a graph: timed changes of parameters, the duration, and the frames per second.
struct GraphScript {
  struct Setting {
    double time_s = 0.0;
    GraphIndex parameter = 0;
    float value = 0.0f;
  };
  std::vector<Setting> settings;  ///< in the order of time
  double duration_s = 5.0, fps = 30.0;
};

/// Reads texts of the form `NAME=VALUE@TIME`, TIME in seconds. Without "@TIME" the time is 0. Any value but 0 fires a
/// trigger.
/// err  a sentence for the user that quotes the faulty text
tl::expected<std::vector<GraphScript::Setting>, std::string> read_settings(const std::vector<std::string>& texts,
                                                                           const GraphDefinition& graph);

/// Plays a graph and records each frame: time, states with their weights and times, pose program, events. `hash` is a
/// checksum of the recorded frames, so a golden test can store the hash alone.
Json trace_graph(const GraphOfModel& model, const GraphScript& script);

/// Formats a result of trace_graph as a text table with one line per frame, and the hash below.
std::string trace_text(const Json& trace);

}  // namespace sinew::tool
