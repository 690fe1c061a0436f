// SPDX-License-Identifier: MIT
#pragma once
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <memory_resource>
#include <span>
#include <vector>

#include "runtime/plan/input_copy.h"
#include "runtime/plan/run_plan.h"
#include "runtime/threads/triple_slots.h"

namespace sinew {

struct CrowdOptions {
  std::size_t inline_below_bytes = 0;  ///< a frame of less memory than this is one task
  std::size_t part_bytes = 0;          ///< of consecutive characters that are one task, at least
  std::uint8_t frame_buffers = 3;      ///< of each character, 2 or 3
  std::pmr::memory_resource* memory = nullptr;
};

/// The characters of a job thread, and one frame of all of them cut into tasks that any thread may run.
/// A frame goes: queue, start, run_task for every task once and on any threads, publish by whoever ran the last one.
/// All but run_task and latest are called while no task runs.
class Crowd {
 public:
  explicit Crowd(const CrowdOptions& options);
  ~Crowd();
  Crowd(const Crowd&) = delete;
  Crowd& operator=(const Crowd&) = delete;

  /// cost allocates frame buffers and room for inputs
  void add(const Plan& plan);
  std::size_t size() const noexcept { return characters_.size(); }

  /// err  size_mismatch (not one input for each character, or an array is longer than its plan needs), too_many_layers
  ErrorCode check(std::span<const FrameInput> inputs) const noexcept;
  /// Every character has a frame buffer to write into; asked by the reader's thread. Always true for three buffers.
  bool can_write() const noexcept;
  /// Copies the inputs of a frame, which start() then takes. The frame before may still be running.
  void queue(std::span<const FrameInput> inputs);
  /// in   number  FrameResult::frame of what the frame gives
  void start(std::uint64_t number) noexcept;

  /// At least 1.
  std::size_t task_count() const noexcept;
  /// Runs one task of the frame that was started.     out  true for the last one to end
  bool run_task(std::size_t task) noexcept;
  std::size_t tasks_run() const noexcept { return tasks_run_.load(std::memory_order_acquire); }

  /// Shows the results of all characters together. One that failed keeps showing its last good frame.
  /// out  the first error in the order of characters
  ErrorCode publish() noexcept;

  /// The newest published result, unchanged until asked for again; null before the first.
  const FrameResult* latest(std::size_t character) noexcept;

 private:
  struct Character;

  void run_part(std::size_t part) noexcept;
  void look_at_input(std::size_t c) noexcept;
  void run_character(std::size_t c, std::uint64_t number) noexcept;

  CrowdOptions options_;
  std::vector<std::unique_ptr<Character>> characters_;
  std::vector<InputCopy> queued_, running_;
  std::vector<std::size_t> part_end_;            // characters of part p: from the end of the one before to part_end_[p]
  std::size_t bytes_ = 0, last_part_bytes_ = 0;  // of the frames of all characters, and of those in the last part

  // These make the writes of one thread visible to the others before and after the tasks, even if the executor orders
  // nothing. They also reveal an executor that leaves out or repeats a task.
  alignas(64) std::atomic<std::uint64_t> started_{0};  // read by all
  alignas(64) std::atomic<std::size_t> tasks_run_{0};  // written by all
};

}  // namespace sinew
