// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "importer/graph/graph_text.h"
#include "runtime/graph/graph_clips.h"
#include "runtime/model/scene.h"

namespace sinew::tool {

/// A graph file, checked against the model whose clips it plays.
struct GraphOfModel {
  GraphDocument document;
  GraphDefinition graph;
  std::vector<GraphClip> clips;  ///< [clip names of the graph]
};

/// Reads a graph file.
/// err  "FILE: POINTER: sentence": a fault of the text or the graph, a clip that the model lacks, a joint of a mask
///      that it lacks
tl::expected<GraphOfModel, std::string> load_graph(const std::string& file, const Scene& scene);

}  // namespace sinew::tool
