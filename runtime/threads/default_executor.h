// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <functional>

namespace sinew {

/// Calls `body(i)` for every i in [0, count), on this thread and others, and returns when all are done. By oneTBB
/// (tbb_executor.cpp), or by threads of our own where the build has no oneTBB (thread_executor.cpp). A thread that
/// waits for its loop runs only items of that loop, so nested loops never start unrelated items on its stack.
void run_in_parallel(std::size_t count, const std::function<void(std::size_t)>& body);

}  // namespace sinew
