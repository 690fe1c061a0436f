// SPDX-License-Identifier: MIT
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <tl/expected.hpp>

#include "importer/graph/graph_text.h"
#include "importer/graph/join_graphs.h"
#include "runtime/base/index.h"
#include "runtime/graph/graph_clips.h"
#include "runtime/model/scene.h"
#include "runtime/playback/root_track.h"

namespace sinew {

/// "FILE: POINTER: sentence", without the pointer if it is empty.
std::string fault_text(const std::string& file, const GraphTextFault& fault);

/// Reads a JSON file of graphs or programs as text.
/// err  "FILE: sentence": no file, or too large a file
tl::expected<std::string, std::string> read_json_file(const std::string& file);

/// Reads a graph file alone. Nodes that refer to other graphs stay.
/// err  "FILE: POINTER: sentence", a fault of the text
tl::expected<GraphDocument, std::string> read_graph_alone(const std::string& file);

/// A graph file, and all files that it refers to, as one document.
struct GraphOfFiles {
  JoinedGraph joined;
  std::vector<std::string> files;  ///< the graph file first, then the files it refers to, each once

  const GraphDocument& document() const noexcept { return joined.document; }
  /// "FILE: POINTER: sentence" for a place in the document, in the file that it comes from.
  std::string text_of(const GraphTextFault& fault) const;
};

/// Reads a graph file with those that it refers to, by names relative to its folder.
/// err  as read_graph_alone and join_graph; graphs that refer to themselves; more than 1,000 references
tl::expected<GraphOfFiles, std::string> read_graph_files(const std::string& file);

/// How a graph plays the clips of a model.
struct GraphBinding {
  std::string variation;             ///< of the graph; empty: its own clips
  std::uint32_t root_joint = kNone;  ///< joint whose motion carries the character; kNone: none does
  RootMotionParts root_parts = {};
  double root_tolerance = 1e-5;  ///< metres and radians
};

/// A graph file, checked against the model whose clips it plays.
struct GraphOfModel {
  GraphOfFiles source;
  GraphDefinition graph;
  GraphClipSet clips;
  std::vector<RootTrack> roots;           ///< [clip names]; the clip set points to them
  std::vector<std::vector<float>> masks;  ///< [masks][joints]
};

/// Reads a graph file for a model. Clips have the names that the model gives them; NAME#2 is the second of that name.
/// err  "FILE: POINTER: sentence": a fault of the text or the graph; a clip, a joint of a mask or a foot that the model
///      lacks; clips whose events or beats make no set; a variation that the graph lacks
tl::expected<GraphOfModel, std::string> load_graph(const std::string& file, const Scene& scene,
                                                   const GraphBinding& binding = {});

/// The first joint of the masks that the model lacks, with its place in the document; nothing if it has all.
std::optional<GraphTextFault> find_mask_fault(const std::map<std::string, std::vector<std::string>>& masks,
                                              const Skeleton& skeleton);

}  // namespace sinew
