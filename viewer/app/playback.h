// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <span>

#include "runtime/model/scene.h"
#include "runtime/plan/run_plan.h"
#include "runtime/playback/playback_clock.h"

namespace sinew::viewer {

/// Playback of one scene as a user controls it: choose a clip, play, pause, seek, step, change speed and looping.
class Playback {
 public:
  static constexpr double kFrame_s = 1.0 / 30.0;  ///< length of a frame step
  static constexpr double kSlowest = 0.05, kFastest = 8.0;

  /// Plays the first clip.
  /// in   scene       must outlive this
  ///      duration_s  of what plays beside each clip and the rest pose, such as a geometry cache: the longer one counts
  explicit Playback(const Scene& scene, double duration_s = 0.0);

  /// Plays a clip from its start, or shows the rest pose (kNone). Speed and looping stay.
  void choose(std::uint32_t clip);
  /// Goes to the next (+1) or previous (-1) clip, around the ends.
  void next(int direction);
  std::uint32_t clip() const noexcept { return clip_; }

  /// Goes on as `before` plays: speed, looping, pause, and the place in the clip.
  /// in   clip  of this scene: the same clip, or kNone for the rest pose; nothing = it is gone, so the first clip plays
  ///            from its start
  void continue_from(const Playback& before, std::optional<std::uint32_t> clip);

  /// Plays or pauses. At the end of a clip that plays once, it plays again from the start.
  void toggle() noexcept;
  void pause() noexcept { playing_ = false; }
  bool playing() const noexcept { return playing_; }

  /// Advances the clip by the real time that passed, if it plays.
  void advance(double dt_s) noexcept;
  void seek(double time_s) noexcept { clock_.seek(time_s); }

  /// Pauses and moves to the next (+1) or previous (-1) multiple of kFrame_s, around the ends.
  void step(int direction) noexcept;

  /// The next speed up or down in .05 .1 .25 .5 .75 1 1.5 2 4 8.
  void faster() noexcept;
  void slower() noexcept;
  void set_speed(double speed) noexcept { clock_.set_speed(speed); }
  double speed() const noexcept { return clock_.speed(); }

  void set_mode(PlayMode mode);
  void next_mode();  ///< repeat, there and back, once, and again
  PlayMode mode() const noexcept { return clock_.mode(); }

  double time_s() const noexcept { return clock_.time_s(); }
  double duration_s() const noexcept { return clock_.duration_s(); }

  /// The layers to evaluate: one, or none for the rest pose. Valid until this object changes.
  std::span<const ClipLayer> layers() noexcept;

  /// Real time between the last two frames; 0 while paused.
  double last_step_s() const noexcept { return last_step_s_; }

  /// The layers to evaluate `frames` frames later, if each takes as long as the last. Valid until this object changes.
  std::span<const ClipLayer> layers_ahead(std::uint32_t frames) noexcept;

 private:
  const Scene* scene_;
  double beside_s_ = 0.0;
  std::uint32_t clip_ = kNone;
  bool playing_ = true;
  PlaybackClock clock_;
  ClipLayer layer_, ahead_;
  double last_step_s_ = 0.0;
};

}  // namespace sinew::viewer
