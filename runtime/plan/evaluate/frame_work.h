// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>

#include "runtime/plan/frame_result.h"
#include "runtime/plan/plan_stages.h"

namespace sinew {

/// Counts the work of a frame while it runs. Measures the time of each stage if Needs::out.stage_times asks for it.
struct FrameWork : WorkCounters {
  /// in   stage_ns[kStageCount]  set to zero here; empty = no times are wanted, and no clock is read
  explicit FrameWork(std::span<std::uint64_t> stage_ns) noexcept;
  /// Continues to count from `counters`, and keeps the times in `stage_ns`.
  FrameWork(std::span<std::uint64_t> stage_ns, const WorkCounters& counters) noexcept;

  /// Adds the time since the last call to this stage.
  void spent_on(Stage stage) noexcept {
    if (!stage_ns_.empty()) add_time(stage);
  }

  bool measures() const noexcept { return !stage_ns_.empty(); }

  const WorkCounters& counters() const noexcept { return *this; }

 private:
  void add_time(Stage stage) noexcept;

  std::span<std::uint64_t> stage_ns_;
  std::chrono::steady_clock::time_point last_;
};

}  // namespace sinew
