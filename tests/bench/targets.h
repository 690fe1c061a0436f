// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace sinew::bench {

/// Names of the instruction sets that this build supports and this machine can run, best first. They are avx3
/// (AVX-512), avx2, sse4, scalar; on ARM neon and scalar. `scalar` runs the kernels with one float at a time, for
/// machines without the others.
std::vector<std::string> target_names();

/// Restricts all jobs of this process to one instruction set.
/// err  false: this build or machine does not have it
bool choose_target(std::string_view name);

/// The compiler of this program, and whether it optimised. Counts of instructions can only be compared for one
/// compiler.
std::string compiler();

}  // namespace sinew::bench
