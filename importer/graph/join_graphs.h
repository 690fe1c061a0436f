// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <optional>
#include <string>

#include "importer/graph/graph_text.h"

namespace sinew {

/// A document, and where the entries come from that other files have given it.
struct JoinedGraph {
  struct Origin {
    std::string file, json_pointer;
  };
  GraphDocument document;
  std::map<std::string, Origin> origins;  ///< by JSON pointer, for example "/nodes/legs~1walk"
};

/// Replaces the node `name` of kind `graph` by the graph that it refers to. The root of that graph takes the name of
/// the node. Other nodes and masks are called "NAME/THEIR NAME". Parameters and beats keep their names, or have those
/// that the node gives them; equal names are the same parameter, and a parameter of `to` wins.
/// in   from  the other graph, without references;   file  its name, for origins and messages
/// err  the place in `to`: a parameter or clip of the node that the graph lacks, a parameter of another kind, beats or
///      variations of one name that differ
std::optional<GraphTextFault> join_graph(JoinedGraph& to, const std::string& name, const JoinedGraph& from,
                                         const std::string& file);

}  // namespace sinew
