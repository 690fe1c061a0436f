// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "runtime/graph/graph_definition.h"

namespace sinew {

inline constexpr std::uint32_t kMostLiveMachines = 64;

/// Memory of a node with all nodes below it, and the most operations that they need at once. Internal to graph/.
struct GraphDemand {
  std::uint32_t bytes = 0;
  std::uint32_t ops = 0;       ///< operations, without the mean that joins the operands into one pose
  std::uint32_t operands = 0;  ///< poses that the node leaves on the stack
  std::uint32_t slots = 0;     ///< most poses on the stack while the node's operations run
  std::uint32_t machines = 0;
  std::uint32_t kept = 0;  ///< operations that keep numbers of their operands
  bool in_model_space = false;
};

/// Offsets and sizes of the parts of a character's state. Internal to graph/.
struct GraphLayout {
  std::vector<std::uint32_t> offsets;         ///< [nodes]
  std::vector<std::uint32_t> largest_states;  ///< [machines]
  std::vector<std::uint32_t> slot_bytes;      ///< [machines]
  GraphDemand demand;                         ///< of the root
};

/// in   tables  without faults, except that they may need too much room
GraphLayout lay_out(const GraphTables& tables);

}  // namespace sinew
