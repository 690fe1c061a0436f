// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include <tl/expected.hpp>

#include "runtime/base/result.h"

namespace sinew {

/// What a clock does at the ends of its clip.
enum class PlayMode : std::uint8_t {
  loop,       ///< time runs in [0, duration): the last key's time is the first one's of the next round, shown once
              ///< (G12). Nothing is interpolated across the seam, unless the clip was closed (animation/close_loop.h).
  clamp,      ///< holds the end; turns back at once when the direction changes
  ping_pong,  ///< forth and back, each end shown once
  once,       ///< as clamp, and the clock is finished at the end until it is sought or turned back
};

/// A stretch of play between two looks at the clock, for EventCursor and root_motion. Phases are clip times for loop,
/// clamp and once; for ping-pong the distance along the way forth and back, in [0, 2 * duration). `turns` counts whole
/// periods apart from the phase, so that hours of play keep every digit (N24).
struct PlaybackStep {
  PlayMode mode = PlayMode::loop;
  double duration_s = 0.0;
  double from_turns = 0.0, from_s = 0.0;
  double to_turns = 0.0, to_s = 0.0;
  bool from_included = false;       ///< the first step after a start or seek also owns the place where it starts
  ErrorCode error = ErrorCode::ok;  ///< not ok: the step was refused, the clock stands where it was, nothing is crossed
};

/// The clock of one clip of one character, in double seconds (N24).
///
/// Sums are compensated, so that a million steps of 1/60 s end where their exact sum ends, and wrapping is exact
/// (std::fmod). Any speed is good, also zero or negative. Numbers that are NaN, infinite or beyond kMost answer
/// not_finite and change nothing: a bad time step of one frame does not break the clock.
class PlaybackClock {
 public:
  static constexpr double kMost = 1e300;  ///< seconds and speed: all sums and products of the clock stay finite

  /// A clock for numbers that the caller does not know to be good.
  /// err  not_finite (a number is NaN, infinite or beyond kMost);  unsupported (a negative duration)
  static Result<PlaybackClock> make(double duration_s, PlayMode mode = PlayMode::loop, double speed = 1.0) noexcept;

  /// in   numbers that make() takes, as durations of clips are; others break a contract
  explicit PlaybackClock(double duration_s, PlayMode mode = PlayMode::loop, double speed = 1.0) noexcept;

  /// Moves on by `dt_s` of the world's time, that is speed() * dt_s of clip time. Answers the stretch that was played.
  /// err  PlaybackStep::error = not_finite: dt_s, or its product with the speed, is NaN, infinite or beyond kMost
  PlaybackStep advance(double dt_s) noexcept;

  /// Jumps to a clip time (clamped to the clip) and starts counting rounds anew; events in between are not crossed.
  /// err  not_finite: the clock stands where it was
  ErrorCode seek(double time_s) noexcept;

  /// err  not_finite (NaN, infinite or beyond kMost): the speed stays
  ErrorCode set_speed(double speed) noexcept;

  double time_s() const noexcept;  ///< clip time in [0, duration], for ClipLayer::time_s
  double duration_s() const noexcept { return duration_s_; }
  double speed() const noexcept { return speed_; }
  PlayMode mode() const noexcept { return mode_; }
  bool finished() const noexcept { return finished_; }  ///< PlayMode::once stands at its end

  /// Whole rounds since the start or seek, negative backwards; for ping-pong forth and back is one round. Exact up to
  /// 2^53 rounds.
  std::int64_t rounds() const noexcept;

 private:
  void wrap_around(double period_s) noexcept;
  void stop_at_ends(double direction) noexcept;

  double duration_s_ = 0.0, speed_ = 1.0;
  double turns_ = 0.0;
  double phase_s_ = 0.0, phase_rest_s_ = 0.0;  // the rest is what rounding took from the phase
  PlayMode mode_ = PlayMode::loop;
  bool finished_ = false, fresh_ = true;
};

}  // namespace sinew
