// SPDX-License-Identifier: MIT
#pragma once
#include <cstdio>
#include <cstdlib>

namespace sinew::detail {
[[noreturn]] inline void contract_failed(const char* condition, const char* file, int line) noexcept {
  std::fprintf(stderr, "sinew: contract broken: %s (%s:%d)\n", condition, file, line);
  std::abort();
}
}  // namespace sinew::detail

/// A bug of the program, not of its input: checked in every build, never used for file contents.
#define CONTRACT(condition) \
  ((condition) ? static_cast<void>(0) : ::sinew::detail::contract_failed(#condition, __FILE__, __LINE__))
