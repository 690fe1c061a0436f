// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include <tl/expected.hpp>

#include "importer/graph/graph_document.h"

namespace sinew {

/// A fault of a graph file: the place (RFC 6901) and a sentence.
struct GraphTextFault {
  std::string json_pointer, sentence;
};

template <class T>
using GraphTextResult = tl::expected<T, GraphTextFault>;

/// Reads the text of a graph. Unknown keys are refused by name, except `editor`, which belongs to editors.
/// err  the first fault: no JSON, an unknown or missing key, a wrong type or word
GraphTextResult<GraphDocument> read_graph(std::string_view text);

/// The text of a document: keys in one order, members that have their defaults left out.
std::string write_graph(const GraphDocument& document);

/// The tables of a document, checked.
/// err  a name that nothing has; whatever find_fault refuses, with its place in the document
GraphTextResult<GraphDefinition> compile_graph(const GraphDocument& document);

/// A table of all members in Markdown, as README.md shows it.
std::string describe_graph_format();

/// A locomotion graph from clip names: gaits on a line of speed, found by words such as idle, walk and run, and jumps
/// beside them. Edit it.
/// err  no clip is called like a gait
GraphTextResult<GraphDocument> new_graph(const std::vector<std::string>& clips);

}  // namespace sinew
