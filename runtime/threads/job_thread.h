// SPDX-License-Identifier: MIT
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <memory_resource>
#include <span>

#include "runtime/base/result.h"
#include "runtime/plan/run_plan.h"

namespace sinew {

/// Names one submitted frame: 1 for the first, rising by one per submit; also FrameResult::frame of what is run for it.
using Ticket = std::uint64_t;

/// Runs `body(i)` for every i in [0, count) and returns when all are done; may use any threads. An engine passes its
/// own job system here; it must call each i exactly once and not throw. Which thread runs which i does not matter:
/// results are the same bits. One i is a run of characters worth handing over, some microseconds of work, so that a
/// crowd of simple characters needs no batches of the executor's own.
using Executor = std::function<void(std::size_t count, const std::function<void(std::size_t)>& body)>;

struct JobThreadOptions {
  Executor executor;  ///< empty = oneTBB
  /// A frame of all characters smaller than this runs on the worker itself (P16): the sum of Plan::frame_bytes, which
  /// goes with the time. Waking threads that slept takes as long as this much work.
  std::size_t inline_below_bytes = std::size_t{1} << 19;
  std::size_t part_bytes = std::size_t{1}
                           << 17;  ///< consecutive characters that the executor is handed as one: at least so much
  std::pmr::memory_resource* frame_memory = nullptr;  ///< of frame buffers and copies of inputs; null = operator new.
                                                      ///< Must outlive the job thread; asked by the calling thread only
};

/// Evaluates frames of many characters beside the caller's thread. Each character has three frame buffers: one being
/// written, one finished, one being read. So the worker never waits for the reader, and the reader never waits for the
/// worker unless it calls wait().
/// owns  one worker thread, the frame buffers of all characters added;   thread-safe: submit and read from one thread
class JobThread {
 public:
  using Character = std::uint32_t;

  explicit JobThread(JobThreadOptions options = {});
  ~JobThread();  ///< finishes the frame in flight, drops the queued one
  JobThread(const JobThread&) = delete;
  JobThread& operator=(const JobThread&) = delete;

  /// Adds a character that runs `plan` (which must outlive the job thread). Not while a frame is in flight: waits for
  /// it.
  Character add_character(const Plan& plan);
  std::size_t character_count() const noexcept;

  /// Queues one frame: inputs[c] is what character c shows. Inputs are copied. No allocation once layer counts have
  /// been seen before.  err size_mismatch (inputs.size() != characters), busy (a frame waits already)
  Result<Ticket> submit(std::span<const FrameInput> inputs);

  Ticket last_submitted() const noexcept;  ///< 0 = none yet
  bool done(Ticket ticket) const noexcept;
  void wait(Ticket ticket) const;

  /// Newest finished frame of a character; stays valid and unchanged until the next call of latest() for that
  /// character. A character whose input is as before is not run: it keeps its result, with the number of the frame that
  /// made it, so that characters who rest or are held (update_rate.h) cost nothing. Null before the first frame is
  /// done.
  const FrameResult* latest(Character character) noexcept;

  /// First error of the last finished frame in the order of characters, ok if none. A character that failed keeps
  /// showing its last good frame.
  ErrorCode last_error() const noexcept;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace sinew
