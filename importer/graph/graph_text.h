// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "importer/graph/graph_document.h"

namespace sinew {

/// An error in a graph file: its place as a JSON pointer (RFC 6901), and a sentence for the user.
struct GraphTextFault {
  std::string json_pointer, sentence;
};

template <class T>
using GraphTextResult = tl::expected<T, GraphTextFault>;

/// Reads the text of a graph. Unknown keys are refused by name, except `editor`, which belongs to editors.
/// err  the first fault: no JSON, an unknown or missing key, a wrong type or word
GraphTextResult<GraphDocument> read_graph(std::string_view text);

/// Writes a document as JSON text. The order of the keys is fixed, and members that equal their default are omitted.
std::string write_graph(const GraphDocument& document);

/// Replaces the names of a document by indices, and checks the resulting tables.
/// err  a reference to a name that is not defined; a fault found by find_fault, with its place in the document
GraphTextResult<GraphDefinition> compile_graph(const GraphDocument& document);

/// The differences between two documents, in words, one sentence each: "node body, state go, transition to stand:
/// duration_s was 0.3 and is 0.5". Transitions, layers and points are found again by the state or node that they name.
/// So one that is added or moved does not change the others. Empty if the graphs are the same.
std::vector<std::string> compare_graphs(const GraphDocument& before, const GraphDocument& after);

/// A picture for GraphViz: nodes with what they play, a frame around the states of each machine, and transitions with
/// their conditions.
std::string draw_graph(const GraphDocument& document);

/// A table of all members in Markdown, as README.md shows it.
std::string describe_graph_format();

/// Drafts a locomotion graph from clip names, for the user to edit. Clips whose names contain a gait (idle, walk, run)
/// are blended by speed; a jump clip gets a state of its own.
/// err  no clip name contains the word of a gait
GraphTextResult<GraphDocument> new_graph(const std::vector<std::string>& clips);

}  // namespace sinew
