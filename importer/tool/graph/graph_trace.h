// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "importer/graph/graph_files.h"
#include "importer/graph/graph_setting.h"
#include "importer/tool/json.h"
#include "runtime/pose_program/pose_program.h"

namespace sinew::tool {

/// A script for playing a graph: timed changes of parameters, the duration, and the frames per second.
struct GraphScript {
  std::vector<GraphSetting> settings;  ///< in the order of time
  double duration_s = 5.0, fps = 30.0;
};

/// Plays a graph and records each frame: time, states with their weights and times, pose program, events. `hash` is a
/// checksum of the recorded frames, so a golden test can store the hash alone.
Json trace_graph(const GraphOfModel& model, const GraphScript& script);

/// The last frame of a script.
struct GraphMoment {
  double time_s = 0.0;
  Json states = Json::array();
  PoseProgram program;
};
GraphMoment play_graph(const GraphOfModel& model, const GraphScript& script);

/// Formats a result of trace_graph as a text table with one line per frame, and the hash below.
std::string trace_text(const Json& trace);

}  // namespace sinew::tool
