// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <thread>

namespace sinew::viewer {

/// Measures the time between pictures, and limits their rate, because some drivers do not wait for the display.
class FramePace {
 public:
  using Clock = std::chrono::steady_clock;

  /// in   period_s  shortest time between two pictures
  explicit FramePace(double period_s)
      : period_(std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(period_s))) {}

  /// Waits until the next picture is due. Call it once after each picture.
  void wait() {
    next_ += period_;
    const auto now = Clock::now();
    if (next_ > now)
      std::this_thread::sleep_until(next_);
    else
      next_ = now;
  }

  /// Call it once for each picture.
  void count_picture() {
    const auto now = Clock::now();
    const double passed_ms = std::chrono::duration<double, std::milli>(now - last_picture_).count();
    last_picture_ = now;
    if (passed_ms < kPause_ms) picture_ms_ += kSmoothing * (passed_ms - picture_ms_);
  }

  /// Time between two pictures: a moving average.
  double picture_ms() const noexcept { return picture_ms_; }

 private:
  static constexpr double kPause_ms = 1000.0;  // a longer gap is a pause, not a slow frame
  static constexpr double kSmoothing = 0.1;

  Clock::duration period_;
  Clock::time_point next_ = Clock::now(), last_picture_ = next_;
  double picture_ms_ = 0.0;
};

}  // namespace sinew::viewer
