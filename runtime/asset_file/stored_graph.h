// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace sinew {

/// A compiled motion graph in an asset file, as write_graph_bytes (graph/graph_bytes.h) writes it. The graph knows the
/// room that its programs need (GraphDefinition::room, for Needs::in.program). It names clips, so the same graph may
/// play the clips of several characters.
struct StoredGraph {
  std::string name;
  std::vector<std::byte> bytes;
};

}  // namespace sinew
