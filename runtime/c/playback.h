// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/api.h"
#include "runtime/c/types.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef enum sinew_play_mode {
  SINEW_PLAY_LOOP = 0,       ///< time runs in [0, duration)
  SINEW_PLAY_CLAMP = 1,      ///< stays at the end
  SINEW_PLAY_PING_PONG = 2,  ///< plays forward, then backward
  SINEW_PLAY_ONCE = 3        ///< like clamp; the clock is finished at the end
} sinew_play_mode;

/// The clock of one clip of one character: a value, to be copied and dropped freely. Its fields are private.
typedef struct sinew_clock {
  double inside[8];
} sinew_clock;

/// The time that one step of a clock played, for sinew_crossed_events and root motion. Its fields are private.
typedef struct sinew_step {
  double inside[8];
} sinew_step;

/// Starts a clock at time 0.
/// in   duration_s >= 0, speed finite;   mode  sinew_play_mode
/// err  SINEW_NULL_ARGUMENT, SINEW_NOT_FINITE, SINEW_UNSUPPORTED (mode)
SINEW_API sinew_error sinew_clock_init(sinew_clock* clock, double duration_s, uint32_t mode, double speed);

/// Advances the clock by `dt_s` of world time.
/// out  step  the time that was played; may be null
/// err  SINEW_NULL_ARGUMENT, SINEW_NOT_FINITE
SINEW_API sinew_error sinew_clock_advance(sinew_clock* clock, double dt_s, sinew_step* step);
SINEW_API sinew_error sinew_clock_seek(sinew_clock* clock, double time_s);  ///< clamped to the clip
SINEW_API sinew_error sinew_clock_set_speed(sinew_clock* clock, double speed);
SINEW_API double sinew_clock_time_s(const sinew_clock* clock);  ///< clip time for sinew_layer.time_s
SINEW_API int64_t sinew_clock_rounds(const sinew_clock* clock);
SINEW_API int sinew_clock_finished(const sinew_clock* clock);

/// The events that a step crosses, in the order of play, once per crossing.
/// in   event_times_s[event_count]  rising, within the clip
/// out  events[capacity]  indices of events; what does not fit is left out
/// Returns the number of crossed events, which may be larger than `capacity`.
SINEW_API size_t sinew_crossed_events(const sinew_step* step, const double* event_times_s, size_t event_count,
                                      uint32_t* events, size_t capacity);

#ifdef __cplusplus
}
#endif
