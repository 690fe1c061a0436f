// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <span>

#include "runtime/model/scene.h"
#include "runtime/plan/run_plan.h"
#include "runtime/playback/playback_clock.h"

namespace sinew::viewer {

/// What a person does with the time of one scene: choose a clip, play, pause, seek, step, change speed and looping.
class Playback {
 public:
  static constexpr double kFrame_s = 1.0 / 30.0;  ///< of a frame step
  static constexpr double kSlowest = 0.05, kFastest = 8.0;

  /// Plays the first clip; the scene must outlive this.
  explicit Playback(const Scene& scene);

  /// Any clip of the scene from its start, or the rest pose (kNone). Speed and looping stay.
  void choose(std::uint32_t clip);
  /// The next clip (+1) or the one before (-1), around the ends.
  void next(int direction);
  std::uint32_t clip() const noexcept { return clip_; }

  /// Stopped at the end of a clip that plays once, it plays from the start again.
  void toggle() noexcept;
  void pause() noexcept { playing_ = false; }
  bool playing() const noexcept { return playing_; }

  /// Moves on by what passed outside, if it plays.
  void advance(double dt_s) noexcept;
  void seek(double time_s) noexcept { clock_.seek(time_s); }

  /// Pauses and moves to the next (+1) or previous (-1) whole frame of kFrame_s; past an end it goes on at the other.
  void step(int direction) noexcept;

  /// Speeds .05 .1 .25 .5 .75 1 1.5 2 4 8: the next one up or down.
  void faster() noexcept;
  void slower() noexcept;
  void set_speed(double speed) noexcept { clock_.set_speed(speed); }
  double speed() const noexcept { return clock_.speed(); }

  void set_mode(PlayMode mode);
  void next_mode();  ///< repeat, there and back, once, and again
  PlayMode mode() const noexcept { return clock_.mode(); }

  double time_s() const noexcept { return clock_.time_s(); }
  double duration_s() const noexcept { return clock_.duration_s(); }

  /// What to evaluate: one layer, or none for the rest pose. Valid until this changes.
  std::span<const ClipLayer> layers() noexcept;

  /// What passed outside between the last two frames; 0 while it does not play.
  double last_step_s() const noexcept { return last_step_s_; }

  /// What to evaluate that many frames later, if time goes on in steps like the last. Valid until this changes.
  std::span<const ClipLayer> layers_ahead(std::uint32_t frames) noexcept;

 private:
  const Scene* scene_;
  std::uint32_t clip_ = kNone;
  bool playing_ = true;
  PlaybackClock clock_;
  ClipLayer layer_, ahead_;
  double last_step_s_ = 0.0;
};

}  // namespace sinew::viewer
