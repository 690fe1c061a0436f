// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace sinew::bench {

/// Names of the instruction sets that this build has kernels for and this machine can run, the best first: avx3 (that
/// is AVX-512), avx2, sse4, scalar; neon and scalar on ARM. `scalar` is what machines without any of the others run:
/// the kernels over one float at a time.
std::vector<std::string> target_names();

/// Holds all jobs of this process to one of them.
/// err  false: no such name
bool choose_target(std::string_view name);

/// The compiler that made this program, and whether it optimised: counts of instructions belong to one compiler.
std::string compiler();

}  // namespace sinew::bench
