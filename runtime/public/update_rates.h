// SPDX-License-Identifier: MIT
#pragma once
/// Small characters are evaluated in every second or fourth frame, in turns. HeldInput repeats a pose in between.
/// InterpolatedInput interpolates between two updates. Both return the FrameInput to run; InputCopy is an input that
/// owns its arrays.
///
///     const sinew::UpdateLevel level = update_level(screen_size(radius_m, distance_m, fov_y_rad), level_before);
///     const sinew::FrameInput input = held.next(now, level, frame, character);
#include "runtime/lod/interpolated_input.h"
#include "runtime/lod/update_rate.h"
#include "runtime/plan/input_copy.h"
