// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/plan/input_copy.h"

namespace sinew {

/// How often a character is evaluated: level k in every 2^k-th frame.
enum class UpdateLevel : std::uint8_t { every, every_second, every_fourth };

/// Where levels change, as parts of the picture's height.
struct UpdateRates {
  double second_below = 0.2;   ///< smaller characters are evaluated in every second frame
  double fourth_below = 0.07;  ///< smaller characters are evaluated in every fourth frame
  double hysteresis = 0.25;    ///< a character must be larger by this part to return to a finer level; avoids flicker
  double longest_s = 0.1;      ///< between updates, whatever the size: where frames are slow, few or none are left out
};

/// Height of a ball in the picture of a perspective camera, as part of the picture's height; infinite from within.
/// eq   r / (d tan(fov_y / 2))
double screen_size(double radius_m, double distance_m, double fov_y_rad) noexcept;

/// in   screen_size  of the character;   before  its level in the last frame
UpdateLevel update_level(double screen_size, UpdateLevel before, const UpdateRates& rates = {}) noexcept;

/// The level itself, or the coarsest finer one whose updates are no farther apart than UpdateRates::longest_s.
/// in   frame_s  from one frame to the next
UpdateLevel limited_level(UpdateLevel level, double frame_s, const UpdateRates& rates = {}) noexcept;

/// Holds a character's input over the frames that its level leaves out. run_plan is given the same input again and does
/// nothing (P19), neither for joints nor for vertices, and nothing is uploaded. Poses are not interpolated in between:
/// skinning interpolated poses would cost what is saved. Everything that decides the pose is held together: layers, the
/// layers of a later time with their interpolation factor, morph weights, the root, sources of vertices and their
/// times. What is out of view or asleep is always of this frame.
/// err  what is shown is up to 2^k - 1 frames old: a vertex is off by at most its speed times (2^k - 1) frame times.
///      The root lags as well; to hide that, draw the character with root_now * inverse(input.root) on top
class HeldInput {
 public:
  explicit HeldInput(const Plan& plan) : held_(plan) {}

  /// The input to run in this frame: `now` in frames in which the character is due and when nothing is held yet,
  /// otherwise the last such input. A character that wakes up is evaluated.
  /// in   phase  of the character, any number; it is due when frame + phase is a multiple of 2^k. Characters that count
  ///             up spread their work over frames
  /// out  views of this object, valid until the next call
  /// cost O(layers + weights), no allocation for inputs within the room of the plan (Needs::layer_room)
  FrameInput next(const FrameInput& now, UpdateLevel level, std::uint64_t frame, std::uint32_t phase);

 private:
  InputCopy held_;
  bool holds_ = false;
};

}  // namespace sinew
