// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory_resource>

#include "runtime/base/api.h"
#include "runtime/base/result.h"

namespace sinew {

/// Runs `body(i)` exactly once for every i in [0, count), on any threads, and returns when all are done. It must not
/// throw. An engine passes its own job system here. Results are the same bits whichever thread runs which i. Each i
/// evaluates several characters, some microseconds of work, so the executor need not group them.
using Executor = std::function<void(std::size_t count, const std::function<void(std::size_t)>& body)>;

struct JobThreadOptions {
  /// Empty = oneTBB, or sinew's own pool in builds without it. If own_thread is false, empty = the thread that polls.
  Executor executor;
  /// A frame is one task, and is not handed to the executor, if the sum of Plan::frame_bytes() of all characters is
  /// below this. That sum grows with the work. Waking sleeping threads takes as long as this much work.
  std::size_t inline_below_bytes = std::size_t{1} << 19;
  /// A task takes consecutive characters until the sum of their Plan::frame_bytes() reaches this.
  std::size_t part_bytes = std::size_t{1} << 17;
  /// Allocates frame buffers and copies of inputs; null = operator new. Must outlive the job thread. Only the thread
  /// that submits calls it: when characters are added, replaced or removed, and in the destructor.
  std::pmr::memory_resource* frame_memory = nullptr;
  bool own_thread = true;  ///< false: no thread is made, frames run where the engine calls poll() or runs tasks
  /// 3 or 2, per character. With 2 a character takes a third less memory, and submit returns busy until the frame
  /// before is finished and latest() has taken its result of every character.
  std::uint8_t frame_buffers = 3;
};

SINEW_API ErrorCode check(const JobThreadOptions& options) noexcept;  ///< unsupported: neither 2 nor 3 frame buffers

}  // namespace sinew
