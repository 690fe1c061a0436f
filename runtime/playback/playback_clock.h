// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include <tl/expected.hpp>

#include "runtime/base/api.h"
#include "runtime/base/result.h"

namespace sinew {

/// Behaviour of a clock at the ends of its clip.
enum class PlayMode : std::uint8_t {
  loop,       ///< time runs in [0, duration). The end of a round is the start of the next one, so it is shown once.
              ///< Nothing is interpolated across the seam, unless the clip was closed (animation/close_loop.h).
  clamp,      ///< stays at the end; leaves it at once if the direction changes
  ping_pong,  ///< plays forward, then backward; each end is shown once
  once,       ///< as clamp; in addition, finished() is true at the end until a seek or a change of direction
};

/// The time that one call of advance played, for EventCursor and root_motion. `from_s` and `to_s` are clip times; in
/// ping-pong they run on to 2 * duration_s on the way back. `from_turns` and `to_turns` count whole periods, so hours
/// of play lose no digits.
struct PlaybackStep {
  PlayMode mode = PlayMode::loop;
  double duration_s = 0.0;
  double from_turns = 0.0, from_s = 0.0;
  double to_turns = 0.0, to_s = 0.0;
  bool from_included = false;       ///< the first step after a start or seek includes the time where it starts
  ErrorCode error = ErrorCode::ok;  ///< if not ok, the clock did not move and no event is crossed
};

/// The clock of one clip of one character, in double seconds.
///
/// Sums are compensated: a million steps of 1/60 s end where their exact sum ends. Wrapping is exact (std::fmod). The
/// speed may be zero or negative. Numbers that are NaN, infinite or beyond kMost return not_finite and change nothing,
/// so a bad time step of one frame does not break the clock.
class SINEW_API PlaybackClock {
 public:
  /// Limit of seconds and speeds. Up to it all sums and products of the clock stay finite.
  static constexpr double kMost = 1e300;

  /// Makes a clock from untrusted numbers.
  /// err  not_finite (a number is NaN, infinite or beyond kMost);  unsupported (a negative duration)
  static Result<PlaybackClock> make(double duration_s, PlayMode mode = PlayMode::loop, double speed = 1.0) noexcept;

  /// in   numbers that make() accepts, such as the duration of a clip; others break a contract
  explicit PlaybackClock(double duration_s, PlayMode mode = PlayMode::loop, double speed = 1.0) noexcept;

  /// Advances by `dt_s` of world time, which is speed() * dt_s of clip time. Returns the step that was played.
  /// err  PlaybackStep::error = not_finite: dt_s, or its product with the speed, is NaN, infinite or beyond kMost
  PlaybackStep advance(double dt_s) noexcept;

  /// Jumps to a clip time (clamped to the clip) and resets rounds(). Events in between are not crossed.
  /// err  not_finite: the clock does not change
  ErrorCode seek(double time_s) noexcept;

  /// err  not_finite (NaN, infinite or beyond kMost): the speed does not change
  ErrorCode set_speed(double speed) noexcept;

  double time_s() const noexcept;  ///< clip time in [0, duration], for ClipLayer::time_s
  double duration_s() const noexcept { return duration_s_; }
  double speed() const noexcept { return speed_; }
  PlayMode mode() const noexcept { return mode_; }
  bool finished() const noexcept { return finished_; }  ///< PlayMode::once has reached its end

  /// Whole rounds since the start or seek, negative for backward play. In ping-pong, forward and backward is one
  /// round. Exact up to 2^53 rounds.
  std::int64_t rounds() const noexcept;

 private:
  void wrap_around(double period_s) noexcept;
  void stop_at_ends(double direction) noexcept;

  double duration_s_ = 0.0, speed_ = 1.0;
  double turns_ = 0.0;
  double phase_s_ = 0.0, phase_rest_s_ = 0.0;  // phase + rest is the compensated sum
  PlayMode mode_ = PlayMode::loop;
  bool finished_ = false, fresh_ = true;
};

}  // namespace sinew
