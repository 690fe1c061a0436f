// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>

#include "runtime/base/api.h"
#include "runtime/plan/input_copy.h"

namespace sinew {

/// How often a character is evaluated: at level k in every 2^k-th frame.
enum class UpdateLevel : std::uint8_t { every, every_second, every_fourth };

/// Screen sizes at which levels change. A size is the height of a character as a fraction of the picture height.
struct UpdateRates {
  double second_below = 0.2;   ///< smaller characters are evaluated in every second frame
  double fourth_below = 0.07;  ///< smaller characters are evaluated in every fourth frame
  double hysteresis = 0.25;  ///< a character must be larger by this fraction to return to a finer level; avoids flicker

  /// Longest time between updates, whatever the size; limited_level chooses a finer level if it would be longer. At low
  /// frame rates characters thus skip few frames or none.
  double longest_s = 0.1;
};

/// Height of a sphere in the picture of a perspective camera, as a fraction of the picture height. Infinite for a
/// camera inside of the sphere.
/// eq   r / (d tan(fov_y / 2))
SINEW_API double screen_size(double radius_m, double distance_m, double fov_y_rad) noexcept;

/// Chooses the level of a character by its screen size.
/// in   screen_size  of the character;   before  its level in the last frame
SINEW_API UpdateLevel update_level(double screen_size, UpdateLevel before, const UpdateRates& rates = {}) noexcept;

/// The level itself, or a finer one if its updates would be farther apart than UpdateRates::longest_s.
/// in   frame_s  time from one frame to the next
SINEW_API UpdateLevel limited_level(UpdateLevel level, double frame_s, const UpdateRates& rates = {}) noexcept;

/// Holds a character's input over the frames that its level leaves out. run_plan gets the same input again and does
/// nothing, neither for joints nor for vertices, and nothing is uploaded. Poses are not interpolated in between:
/// skinning interpolated poses would cost what is saved. All input that decides the pose is held together: layers,
/// interpolation with a later time, morph weights, the root, vertex sources and their times. Visibility (out of view,
/// asleep) is always that of the current frame.
/// err  the shown frame is up to 2^k - 1 frames old: a vertex is off by at most its speed times (2^k - 1) frame times.
///      The root lags as well; to hide that, draw the character with root_now * inverse(input.root) on top
class SINEW_API HeldInput {
 public:
  explicit HeldInput(const Plan& plan) : held_(plan) {}

  /// The input to run in this frame. It is `now` if the character is due, wakes up or has no input yet; otherwise it is
  /// the held input.
  /// in   phase  any number per character; it is due when frame + phase is a multiple of 2^k. Consecutive numbers
  ///      spread the work of many characters over frames
  /// out  views into this object, valid until the next call
  /// cost O(layers + weights), no allocation for inputs within the room of the plan (Needs::in.layer_room)
  FrameInput next(const FrameInput& now, UpdateLevel level, std::uint64_t frame, std::uint32_t phase);

 private:
  InputCopy held_;
  bool holds_ = false;
};

}  // namespace sinew
