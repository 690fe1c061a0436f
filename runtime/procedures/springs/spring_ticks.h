// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/procedures/springs/spring_memory.h"

namespace sinew::springs {

/// The simulation steps of one frame of one character, with all joints of a depth side by side in vector lanes.
struct Ticks {
  const SpringTables& tables;
  const SpringMemory& memory;
  Planes<const double> inputs;  ///< planes of input::Plane
  bool is_uniform;              ///< no scale shears a joint
};

/// Places all input frames and colliders at a time between the last frames, or after them.
void place_inputs(const Ticks& ticks, const FrameWeights& weights) noexcept;

/// Puts all tails at their goals, without velocity.
void reset_tails(const Ticks& ticks) noexcept;

/// Runs a tick from SpringMemory::tails to SpringMemory::next. True if a joint moved faster than the threshold.
/// in   threshold  square of the angle that a quiet joint turns in a tick, at most
///      shows      also writes SpringMemory::shown, as a show_tails() after the tick would
bool run_tick(const Ticks& ticks, double threshold, bool shows) noexcept;

/// Makes the result of the last tick the current state.
void commit_tick(const Ticks& ticks) noexcept;

/// Writes SpringMemory::shown for tails at `fraction` of the way from the last tick to `next`. At 0 `next` is not read.
void show_tails(const Ticks& ticks, double fraction) noexcept;

}  // namespace sinew::springs
