// SPDX-License-Identifier: MIT
#include "runtime/playback/playback_clock.h"

#include <algorithm>
#include <cmath>

#include "runtime/base/contract.h"

namespace sinew {
namespace {

/// eq   sum + error = a + b exactly   (Knuth, TAOCP 2, 4.2.2, theorem B)
struct SumAndRest {
  double sum, error;
};

SumAndRest add(double a, double b) noexcept {
  const double sum = a + b;
  const double b_kept = sum - a;
  return {sum, (a - (sum - b_kept)) + (b - b_kept)};
}

/// True for finite numbers up to kMost; false for NaN.
bool is_usable(double number) noexcept { return std::fabs(number) <= PlaybackClock::kMost; }

}  // namespace

Result<PlaybackClock> PlaybackClock::make(double duration_s, PlayMode mode, double speed) noexcept {
  if (!is_usable(duration_s) || !is_usable(speed)) return tl::unexpected(ErrorCode::not_finite);
  if (duration_s < 0.0) return tl::unexpected(ErrorCode::unsupported);
  return PlaybackClock(duration_s, mode, speed);
}

PlaybackClock::PlaybackClock(double duration_s, PlayMode mode, double speed) noexcept
    : duration_s_(duration_s), speed_(speed), mode_(mode) {
  CONTRACT(is_usable(duration_s) && duration_s >= 0.0 && is_usable(speed));
}

PlaybackStep PlaybackClock::advance(double dt_s) noexcept {
  const double delta_s = speed_ * dt_s;
  PlaybackStep step{mode_, duration_s_, turns_, phase_s_, turns_, phase_s_, fresh_, ErrorCode::ok};
  if (!is_usable(dt_s) || !is_usable(delta_s)) {
    step.from_included = false;
    step.error = ErrorCode::not_finite;
    return step;
  }
  const SumAndRest moved = add(phase_s_, delta_s);
  const SumAndRest tidy = add(moved.sum, moved.error + phase_rest_s_ + std::fma(speed_, dt_s, -delta_s));
  phase_s_ = tidy.sum;
  phase_rest_s_ = tidy.error;
  if (mode_ == PlayMode::loop)
    wrap_around(duration_s_);
  else if (mode_ == PlayMode::ping_pong)
    wrap_around(2.0 * duration_s_);
  else
    stop_at_ends(delta_s);
  fresh_ = false;
  step.to_turns = turns_;
  step.to_s = phase_s_;
  return step;
}

void PlaybackClock::wrap_around(double period_s) noexcept {
  if (period_s == 0.0) {
    phase_s_ = phase_rest_s_ = 0.0;
    return;
  }
  const double total_s = phase_s_;
  double phase_s = std::fmod(total_s, period_s);
  if (phase_s < 0.0) {
    const SumAndRest lifted = add(phase_s, period_s);
    phase_s = lifted.sum < period_s ? lifted.sum : 0.0;  // a time just before the seam may round to it
    phase_rest_s_ += lifted.error;
  }
  turns_ = std::clamp(turns_ + std::nearbyint((total_s - phase_s) / period_s), -kMost, kMost);
  phase_s_ = phase_s + 0.0;  // turns -0 into 0
}

void PlaybackClock::stop_at_ends(double direction) noexcept {
  const bool at_end = (direction > 0.0 && phase_s_ >= duration_s_) || (direction < 0.0 && phase_s_ <= 0.0);
  if (at_end) {
    phase_s_ = direction > 0.0 ? duration_s_ : 0.0;
    phase_rest_s_ = 0.0;
  }
  if (mode_ == PlayMode::once && direction != 0.0) finished_ = at_end;
}

ErrorCode PlaybackClock::seek(double time_s) noexcept {
  if (!std::isfinite(time_s)) return ErrorCode::not_finite;
  phase_s_ = std::clamp(time_s, 0.0, duration_s_);
  phase_rest_s_ = turns_ = 0.0;
  finished_ = false;
  fresh_ = true;
  return ErrorCode::ok;
}

ErrorCode PlaybackClock::set_speed(double speed) noexcept {
  if (!is_usable(speed)) return ErrorCode::not_finite;
  speed_ = speed;
  return ErrorCode::ok;
}

double PlaybackClock::time_s() const noexcept {
  return phase_s_ <= duration_s_ ? phase_s_ : 2.0 * duration_s_ - phase_s_;
}

std::int64_t PlaybackClock::rounds() const noexcept {
  constexpr double kMostRounds = 9.0e18;
  return static_cast<std::int64_t>(std::clamp(turns_, -kMostRounds, kMostRounds));
}

}  // namespace sinew
