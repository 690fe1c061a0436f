// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "runtime/math/dual_quaternion.h"
#include "runtime/playback/playback_clock.h"

namespace sinew {

/// A motion repeated `count` times.
/// eq   m^count by repeated squaring; a negative count is the power of the inverse
inline DualQuatd power(DualQuatd m, double count) noexcept {
  constexpr double kMostTurns = 9.0e15;
  if (count < 0.0) m = dual_quat_conjugate(m);
  DualQuatd result;
  for (auto left = static_cast<std::uint64_t>(std::min(std::fabs(count), kMostTurns)); left > 0; left /= 2) {
    if (left % 2 != 0) result = normalised(result * m);
    m = normalised(m * m);
  }
  return result;
}

/// The motion of a step of the clock, from the place at each clip time: the equation of root_motion.
template <class PlaceAt>
DualQuatd carried_motion(const PlaceAt& place, const PlaybackStep& step) noexcept {
  // Ping-pong counts phases along the way forth and back; the way back runs from the end to the start.
  const auto place_at_phase = [&](double phase_s) {
    return place(phase_s <= step.duration_s ? phase_s : 2.0 * step.duration_s - phase_s);
  };
  const DualQuatd back = dual_quat_conjugate(place_at_phase(step.from_s));
  const DualQuatd to = place_at_phase(step.to_s);
  if (step.mode != PlayMode::loop || step.to_turns == step.from_turns) return normalised(back * to);
  const DualQuatd round = place(step.duration_s) * dual_quat_conjugate(place(0.0));
  return normalised(back * power(round, step.to_turns - step.from_turns) * to);
}

}  // namespace sinew
