// SPDX-License-Identifier: MIT
#pragma once
#include "runtime/base/api.h"
#include "runtime/c/frame.h"

#ifdef __cplusplus
extern "C" {
#endif

/// How often a character is evaluated: level k in every 2^k-th frame.
typedef enum sinew_update_level {
  SINEW_UPDATE_EVERY = 0,
  SINEW_UPDATE_EVERY_SECOND = 1,
  SINEW_UPDATE_EVERY_FOURTH = 2
} sinew_update_level;

/// Screen sizes at which levels change, as fractions of the picture height.
typedef struct sinew_update_rates {
  size_t struct_size;
  double second_below;  ///< smaller characters are evaluated in every second frame
  double fourth_below;  ///< smaller characters are evaluated in every fourth frame
  double hysteresis;    ///< a character must be larger by this fraction to return to a finer level
  double longest_s;     ///< longest time between updates, at any size
} sinew_update_rates;
SINEW_API sinew_update_rates sinew_default_update_rates(void);

/// Height of a sphere in the picture of a perspective camera, as a fraction of the picture height; infinite from
/// within.
SINEW_API double sinew_screen_size(double radius_m, double distance_m, double fov_y_rad);

/// The level of a character of this size. It is finer where updates would be more than longest_s apart.
/// in   before  its level in the last frame;   frame_s  time from one frame to the next, 0 = no limit
///      rates   null = sinew_default_update_rates
/// err  SINEW_NULL_ARGUMENT, SINEW_WRONG_STRUCT_SIZE, SINEW_UNSUPPORTED (before), SINEW_NOT_FINITE (a number is NaN)
SINEW_API sinew_error sinew_choose_update_level(double screen_size, uint32_t before, double frame_s,
                                                const sinew_update_rates* rates, uint32_t* level);

/// Number of frames until a character of the level is due again; 0 for a level that does not exist.
SINEW_API uint32_t sinew_frames_to_update(uint32_t level, uint64_t frame, uint32_t phase);

/// Holds a character's input over the frames that its level leaves out: running the same input again costs nothing.
/// `out_of_view` and `asleep` are always those of this frame.
typedef struct sinew_held_input sinew_held_input;

/// Creates a held input, at first without an input.
/// in   plan  must outlive the held input
/// err  SINEW_NULL_ARGUMENT, SINEW_OUT_OF_MEMORY
SINEW_API sinew_error sinew_held_input_create(const sinew_plan* plan, sinew_held_input** out);
SINEW_API void sinew_held_input_destroy(sinew_held_input* held);

/// The input to run in this frame: `now` if the character is due, otherwise the input of the last frame in which it was
/// due.
/// in   now    null = the rest pose;   level  sinew_update_level
///      phase  of the character, any number: characters that count up spread their work over frames
/// out  input  views of `held` and of `now`, valid until the next call. Procedures of programs are not copied: they
///             stay as they are while the input is held
/// err  SINEW_NULL_ARGUMENT, SINEW_WRONG_STRUCT_SIZE, SINEW_TOO_MANY_LAYERS, SINEW_SIZE_MISMATCH (more weights than the
///      scene has), SINEW_UNSUPPORTED (level, kind of layer, space of an override), SINEW_NOT_IN_NEEDS (more of a
///      program than the needs declare)
SINEW_API sinew_error sinew_held_input_next(sinew_held_input* held, const sinew_frame_input* now, uint32_t level,
                                            uint64_t frame, uint32_t phase, sinew_frame_input* input);

/// Evaluates a character at the frames of its level and interpolates the pose in between, without lag.
typedef struct sinew_interpolated_input sinew_interpolated_input;

/// Creates an interpolated input, at first without poses.
/// in   plan  with SINEW_NEED_BETWEEN_UPDATES; must outlive the input
/// err  SINEW_NULL_ARGUMENT, SINEW_NOT_IN_NEEDS (another plan), SINEW_OUT_OF_MEMORY
SINEW_API sinew_error sinew_interpolated_input_create(const sinew_plan* plan, sinew_interpolated_input** out);
SINEW_API void sinew_interpolated_input_destroy(sinew_interpolated_input* interpolated);

/// The input to run in this frame.
/// in   ahead[ahead_count]  layers of the next frame in which the character is due: sinew_frames_to_update() frames
///      after this one
/// out, err  as sinew_held_input_next, and SINEW_UNSUPPORTED where the input has pages
SINEW_API sinew_error sinew_interpolated_input_next(sinew_interpolated_input* interpolated,
                                                    const sinew_frame_input* now, const sinew_layer* ahead,
                                                    size_t ahead_count, uint32_t level, uint64_t frame, uint32_t phase,
                                                    sinew_frame_input* input);
/// Starts anew in the next frame. Call it after a cut, where interpolating from the previous pose would be wrong.
SINEW_API void sinew_interpolated_input_restart(sinew_interpolated_input* interpolated);

#ifdef __cplusplus
}
#endif
