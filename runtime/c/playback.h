// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/api.h"
#include "runtime/c/pose_program.h"
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

/// Share of each operation's pose in the final pose, for events and sounds of the clips that it samples. Masks count
/// as 1.
/// in   ops  a program that has no fault
/// out  shares[op_count]
/// err  SINEW_NULL_ARGUMENT, and the codes by which programs are refused
SINEW_API sinew_error sinew_op_shares(const sinew_pose_op* ops, size_t op_count, float* shares);

/// A clip that plays together with others in one step of a program. A clip that several operations sample by one clock
/// plays once, with the sum of their shares (sinew_op_shares). This struct never grows.
typedef struct sinew_playing_clip {
  sinew_step step;              ///< of the clip's clock
  const double* event_times_s;  ///< [event_count] rising, within the clip
  size_t event_count;
  double step_s;        ///< length of the step in clip time: speed * dt
  float weight_before;  ///< in the pose of the frame before; 0 = the clip has just begun
  float weight_after;   ///< in the pose of this frame; 0 = the clip has just been faded out
} sinew_playing_clip;

/// An event that a step of several clips crosses. This struct never grows.
typedef struct sinew_blended_event {
  uint32_t clip;   ///< index into the clips that play
  uint32_t event;  ///< index of the clip's event
  double moment;   ///< [0, 1] part of the step that has passed
  float weight;    ///< of the clip at that moment
} sinew_blended_event;

/// The events of all clips that play in one step, in the order of time, each once per crossing. Pass the
/// clips of this frame's program and of the previous one, so that the last step of a faded clip counts.
/// in   playing[count]  at most 255
/// out  events[capacity]  what does not fit is left out;   crossed  number of events, which may be larger than `capacity`
/// err  SINEW_NULL_ARGUMENT, SINEW_UNSUPPORTED (more clips)
SINEW_API sinew_error sinew_blended_events(const sinew_playing_clip* playing, size_t count, sinew_blended_event* events,
                                           size_t capacity, size_t* crossed);

#ifdef __cplusplus
}
#endif
