// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <span>

#include "runtime/plan/frame_result.h"
#include "runtime/plan/plan_stages.h"

namespace sinew {

/// What one frame does while it does it: counts, and where Needs::stage_times asks for them the times of the stages.
struct FrameWork : WorkCounters {
  /// in   stage_ns[kStageCount]  set to zero here; empty = nobody asks, and no clock is read
  explicit FrameWork(std::span<std::uint64_t> stage_ns) noexcept;

  /// What has passed since the last call was spent on this stage.
  void spent_on(Stage stage) noexcept {
    if (!stage_ns_.empty()) add_time(stage);
  }

  const WorkCounters& counters() const noexcept { return *this; }

 private:
  void add_time(Stage stage) noexcept;

  std::span<std::uint64_t> stage_ns_;
  std::chrono::steady_clock::time_point last_;
};

}  // namespace sinew
