// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace sinew::cost {

/// Instructions that this build has kernels for and this machine can run.
struct InstructionSet {
  std::int64_t target = 0;  ///< of Highway
  std::string name;
  std::size_t float_lanes = 1;
  bool fused = false;    ///< a * b + c rounds once
  bool is_best = false;  ///< the one that is used
};

/// The best first.
std::vector<InstructionSet> instruction_sets();

/// Keeps the jobs of this process to one set, until all are allowed again. Asking the processor what it can may take
/// long.
void allow_only(const InstructionSet& set);
void allow_all_instruction_sets();

}  // namespace sinew::cost
