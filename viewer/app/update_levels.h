// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "runtime/lod/interpolated_input.h"
#include "runtime/plan/frame_result.h"
#include "viewer/passes/view.h"

namespace sinew::viewer {

/// Update rate of meshes that are small in the picture: every frame, or fewer frames with interpolated or held poses in
/// between.
enum class Updates : std::uint8_t { every, interpolated, held };

/// "every", "interpolated", "held"
std::string_view name_of(Updates updates) noexcept;

/// Height of the largest visible mesh relative to the picture's height, from its bounding sphere. Infinite if the eye
/// is inside the sphere, 0 if nothing is in view.
double size_in_picture(const FrameResult& frame, const View& view) noexcept;

/// Decides in which frames the character is evaluated (update_rate.h), and makes the input of the frames in between.
class UpdateLevels {
 public:
  /// in   plan  compiled with Needs::in.between_updates if updates are interpolated
  UpdateLevels(const Plan& plan, Updates updates);

  /// Begins the next frame.
  /// in   size_in_picture  size of the character in its last pose;   frame_s  seconds between pictures
  void begin_frame(double size_in_picture, double frame_s) noexcept;

  /// Begins the next frame and forces its exact evaluation.
  /// in   why  the cause; reason() returns "every frame: " followed by it
  void begin_exact_frame(std::string_view why);

  /// Number of frames until the next evaluated frame.
  std::uint32_t frames_to_update() const noexcept { return sinew::frames_to_update(level_, frame_, 0); }

  /// The input of this frame. Repeated calls return the same input.
  /// in   ahead  layers of the frame that is frames_to_update() frames from now
  FrameInput input(const FrameInput& now, std::span<const ClipLayer> ahead);

  UpdateLevel level() const noexcept { return level_; }

  /// For example "every 4th frame, interpolated in between: 3 % of the picture's height".
  std::string reason() const;

 private:
  Updates updates_;
  UpdateLevel by_size_ = UpdateLevel::every, level_ = UpdateLevel::every;
  double size_ = 0.0;
  std::string why_exact_;  // empty = the size decides
  std::uint64_t frame_ = 0;
  std::optional<InterpolatedInput> between_;
  HeldInput held_;
};

}  // namespace sinew::viewer
