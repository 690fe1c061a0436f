// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <functional>

namespace sinew {

/// Calls `body(i)` for every i in [0, count), on this thread and others, and returns when all are done. By oneTBB
/// (tbb_executor.cpp), or by threads of our own where the build has no oneTBB (thread_executor.cpp). A thread that
/// waits here runs calls of its own loop only, so that nested loops keep few items at work.
void run_in_parallel(std::size_t count, const std::function<void(std::size_t)>& body);

}  // namespace sinew
