// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <vector>

#include "runtime/graph/graph_clips.h"
#include "runtime/graph/graph_definition.h"
#include "runtime/playback/root_track.h"

// The structs behind the graph handles of the C interface, for C++ code that hands its own graph to C:
//     return new sinew_graph{std::move(definition)};

struct sinew_graph {
  sinew::GraphDefinition definition;
};

struct sinew_graph_clips {
  std::vector<std::unique_ptr<sinew::RootTrack>> roots;
  sinew::GraphClipSet set;
};
