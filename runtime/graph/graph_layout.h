// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "runtime/graph/graph_definition.h"

namespace sinew {

inline constexpr std::uint32_t kMostLiveMachines = 64;

/// Memory of a node with all below it, and the most that can be live of it at once. Internal to graph/.
struct GraphDemand {
  std::uint32_t bytes = 0;
  std::uint32_t ops = 0;       ///< without the mean that makes one pose of its operands
  std::uint32_t operands = 0;  ///< poses that it leaves
  std::uint32_t slots = 0;     ///< poses on the stack while it runs
  std::uint32_t machines = 0;
  std::uint32_t kept = 0;  ///< operations that keep their operands' work
  bool in_model_space = false;
};

/// Where states lie. Internal to graph/.
struct GraphLayout {
  std::vector<std::uint32_t> offsets;         ///< [nodes]
  std::vector<std::uint32_t> largest_states;  ///< [machines]
  std::vector<std::uint32_t> slot_bytes;      ///< [machines]
  GraphDemand demand;                         ///< of the root
};

/// in   tables  that find_fault accepts, except that they may ask for too much
GraphLayout lay_out(const GraphTables& tables);

}  // namespace sinew
