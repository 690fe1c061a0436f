// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/result.h"

namespace sinew {

/// Runs a job if its buffers and numbers fit. A job is a struct of views with two functions beside it:
/// check(job) names the broken rule, and run_unchecked(job) does the work without looking.
/// Call run_unchecked only where check(job) is known to be ok, as in a compiled plan; debug builds assert it.
/// err  as check(job); the job's output is untouched then
template <class Job>
requires requires(const Job& job) {
  check(job);
  run_unchecked(job);
}
[[nodiscard]] ErrorCode run(const Job& job) noexcept {
  const ErrorCode code = check(job);
  if (code == ErrorCode::ok) run_unchecked(job);
  return code;
}

/// False if a view has a size but no memory. check(job) refuses such views as size_mismatch.
template <class... Spans>
constexpr bool have_memory(const Spans&... spans) noexcept {
  return ((spans.empty() || spans.data() != nullptr) && ...);
}

}  // namespace sinew
