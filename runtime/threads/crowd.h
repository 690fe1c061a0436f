// SPDX-License-Identifier: MIT
#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>

#include "runtime/plan/run_plan.h"
#include "runtime/threads/roster.h"

namespace sinew {

/// One frame of all characters of a job thread, cut into tasks that any thread may run.
/// For each frame call queue() and start(), then run_task() once for every task, on any threads. If stops_at_cut() is
/// true then, call start_second_half() once the caller has changed the poses, and run each task again. The thread that
/// ends the last task calls publish().
class Crowd {
 public:
  /// in   inline_below_bytes  a frame of less memory than this is one task
  explicit Crowd(std::size_t inline_below_bytes) noexcept : inline_below_bytes_(inline_below_bytes) {}

  /// Reserves memory, so that queue() allocates nothing for up to `count` characters with `link_count` followed joints.
  /// Both may be called while a frame runs.
  void make_room(std::size_t count, std::size_t link_count);
  /// Copies the roster of a frame, which start() then takes.
  void queue(const Roster& roster);
  /// Starts the queued frame, whose tasks may then run.
  /// in   number  FrameResult::frame of the results
  void start(std::uint64_t number) noexcept;

  /// True if characters wait at the cut. Call it when all tasks have ended.
  bool stops_at_cut() const noexcept { return stops_.load(std::memory_order_relaxed); }
  /// Makes the tasks ready for the second half of the frame.
  void start_second_half() noexcept;

  /// At least 1.
  std::size_t task_count() const noexcept;
  /// Runs one task of the frame that was started.     out  true for the last one to end
  bool run_task(std::size_t task) noexcept;
  std::size_t tasks_run() const noexcept { return tasks_run_.load(std::memory_order_acquire); }

  /// Shows the results of all characters together. A character whose frame failed keeps showing its last good frame.
  /// out  the first error in the order of characters
  ErrorCode publish() noexcept;

 private:
  void run_part(std::size_t part) noexcept;
  void run_second_half(std::size_t first, std::size_t end, std::uint64_t number) noexcept;
  void run_character(const Roster::Entry& entry, std::uint64_t number) noexcept;

  std::size_t inline_below_bytes_;
  Roster queued_, running_, spare_;  // spare_ replaces queued_ if that has too little capacity

  bool is_second_half_ = false;
  std::atomic<bool> stops_{false};

  // Acquire and release on these order memory before, between and after the tasks, even if the executor does not
  // synchronise. The count also reveals an executor that leaves out or repeats a task.
  alignas(64) std::atomic<std::uint64_t> started_{0};  // read by all
  alignas(64) std::atomic<std::size_t> tasks_run_{0};  // written by all
};

}  // namespace sinew
