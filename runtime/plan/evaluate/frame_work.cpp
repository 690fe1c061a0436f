// SPDX-License-Identifier: MIT
#include "runtime/plan/evaluate/frame_work.h"

#include <algorithm>

namespace sinew {

FrameWork::FrameWork(std::span<std::uint64_t> stage_ns) noexcept : stage_ns_(stage_ns) {
  if (stage_ns_.empty()) return;
  std::fill(stage_ns_.begin(), stage_ns_.end(), 0);
  last_ = std::chrono::steady_clock::now();
}

FrameWork::FrameWork(std::span<std::uint64_t> stage_ns, const WorkCounters& counters) noexcept
    : WorkCounters(counters), stage_ns_(stage_ns) {
  if (!stage_ns_.empty()) last_ = std::chrono::steady_clock::now();
}

void FrameWork::add_time(Stage stage) noexcept {
  const auto now = std::chrono::steady_clock::now();
  stage_ns_[static_cast<std::size_t>(stage)] +=
      static_cast<std::uint64_t>(std::chrono::nanoseconds(now - last_).count());
  last_ = now;
}

}  // namespace sinew
