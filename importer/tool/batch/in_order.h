// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <functional>
#include <string>

#include "importer/tool/exit_code.h"

namespace sinew::tool {

/// The result of a job on one file: its exit code, and its output.
struct JobOutcome {
  ExitCode code = ExitCode::done;
  std::string results, messages;
};

/// Most outcomes, for each job, that wait until those before them are shown. So many small files are done beside a
/// large one.
inline constexpr std::size_t kWaitingPerJob = 1024;

/// No new work begins while waiting outcomes hold more text than this.
inline constexpr std::size_t kMostWaitingBytes = std::size_t{16} << 20;

/// The number of jobs that keeps all cores of this machine busy.
std::size_t cores_to_use();

/// By oneTBB (in_order_tbb.cpp), or by threads of our own where the build has no oneTBB (in_order_threads.cpp).
/// Calls work(0), work(1), ... on up to `jobs` threads, and show() with each outcome in that order, as early as
/// possible.
/// in    work   is called on any thread, several at a time; show is called by one thread at a time
///       jobs   1 or more
/// cost  at most `jobs` calls of `work` run, and at most kWaitingPerJob * jobs outcomes exist, whatever `count` is.
///       They hold at most `most_waiting_bytes`, and the outcomes of one more call for each job
///       hold at most `most_waiting_bytes`, and the outcomes of one more call for each job
void run_in_order(std::size_t count, std::size_t jobs, const std::function<JobOutcome(std::size_t)>& work,
                  const std::function<void(std::size_t, JobOutcome&&)>& show,
                  std::size_t most_waiting_bytes = kMostWaitingBytes);

}  // namespace sinew::tool
