// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace sinew::cost {

/// An instruction set for which this build has kernels and which this machine can run.
struct InstructionSet {
  std::int64_t target = 0;  ///< Highway's number of the target
  std::string name;
  std::size_t float_lanes = 1;
  bool fused = false;    ///< a * b + c rounds once
  bool is_best = false;  ///< the set that is used by default
};

/// All sets, the best first.
std::vector<InstructionSet> instruction_sets();

/// Restricts the jobs of this process to one set, until all are allowed again. May be slow: it queries the processor.
void allow_only(const InstructionSet& set);
void allow_all_instruction_sets();

}  // namespace sinew::cost
