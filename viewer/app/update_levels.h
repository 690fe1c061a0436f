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

/// What happens to meshes that are small in the picture: every frame is evaluated all the same, or fewer, with poses in
/// between interpolated or held.
enum class Updates : std::uint8_t { every, interpolated, held };

/// "every", "interpolated", "held"
std::string_view name_of(Updates updates) noexcept;

/// Height of the largest mesh that a frame shows, as part of the picture's height, from the boxes of its vertices;
/// infinite around the eye, 0 where nothing is in view.
double size_in_picture(const FrameResult& frame, const View& view) noexcept;

/// Chooses which frames of the character in the picture are evaluated (update_rate.h), and what the others show.
class UpdateLevels {
 public:
  /// in   plan  with Needs::between_updates where updates are interpolated
  UpdateLevels(const Plan& plan, Updates updates);

  /// The next frame begins, of a picture in which the last pose was that large.
  /// in   frame_s  from one picture to the next
  void begin_frame(double size_in_picture, double frame_s) noexcept;

  /// The next frame begins, and shows what is asked for exactly: `why` as after "every frame: ".
  void begin_exact_frame(std::string_view why);

  /// Frames from this one to the next that is evaluated.
  std::uint32_t frames_to_update() const noexcept { return sinew::frames_to_update(level_, frame_, 0); }

  /// What to run in this frame; may be asked for again.
  /// in   ahead  layers of the frame that is frames_to_update from now
  FrameInput input(const FrameInput& now, std::span<const ClipLayer> ahead);

  UpdateLevel level() const noexcept { return level_; }

  /// "every 4th frame, interpolated: 3 % of the picture's height"
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
