// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <span>

#include "runtime/model/scene.h"
#include "runtime/plan/run_plan.h"
#include "runtime/playback/playback_clock.h"

namespace sinew::viewer {

/// User-controlled playback of one scene: choose a clip, play, pause, seek, step, change speed and looping.
class Playback {
 public:
  static constexpr double kFrame_s = 1.0 / 30.0;  ///< time that step() moves by
  static constexpr double kSlowest = 0.05, kFastest = 8.0;

  /// Plays the first clip.
  /// in   scene       must outlive this
  ///      duration_s  duration of a geometry cache, 0 without one; the longer of clip and cache is played
  explicit Playback(const Scene& scene, double duration_s = 0.0);

  /// Plays a clip from its start, or shows the rest pose (kNone). Keeps speed and looping.
  void choose(std::uint32_t clip);
  /// Chooses the next (+1) or previous (-1) clip, wrapping around.
  void next(int direction);
  std::uint32_t clip() const noexcept { return clip_; }

  /// Copies the state of `before`: speed, looping, pause, and the position in the clip.
  /// in   clip  the corresponding clip of this scene, or kNone for the rest pose. Empty = it no longer exists, so the
  ///      first clip plays from its start
  void continue_from(const Playback& before, std::optional<std::uint32_t> clip);

  /// Plays or pauses. At the end of a clip that plays once, restarts it.
  void toggle() noexcept;
  void pause() noexcept { playing_ = false; }
  bool playing() const noexcept { return playing_; }

  /// Advances the clip by a span of real time, unless paused.
  void advance(double dt_s) noexcept;
  void seek(double time_s) noexcept { clock_.seek(time_s); }

  /// Pauses and moves to the next (+1) or previous (-1) multiple of kFrame_s, wrapping around.
  void step(int direction) noexcept;

  /// The next speed up or down in .05 .1 .25 .5 .75 1 1.5 2 4 8.
  void faster() noexcept;
  void slower() noexcept;
  void set_speed(double speed) noexcept { clock_.set_speed(speed); }
  double speed() const noexcept { return clock_.speed(); }

  void set_mode(PlayMode mode);
  void next_mode();  ///< cycles through loop, ping-pong, once
  PlayMode mode() const noexcept { return clock_.mode(); }

  double time_s() const noexcept { return clock_.time_s(); }
  double duration_s() const noexcept { return clock_.duration_s(); }

  /// The clip layers to evaluate: one, or none for the rest pose. Valid until this object changes.
  std::span<const ClipLayer> layers() noexcept;

  /// Argument of the last advance(); 0 while paused.
  double last_step_s() const noexcept { return last_step_s_; }

  /// The clip layers `frames` frames from now, assuming that each frame lasts as long as the last one. Valid until this
  /// object changes.
  std::span<const ClipLayer> layers_ahead(std::uint32_t frames) noexcept;

 private:
  const Scene* scene_;
  double least_duration_s_ = 0.0;
  std::uint32_t clip_ = kNone;
  bool playing_ = true;
  PlaybackClock clock_;
  ClipLayer layer_, ahead_;
  double last_step_s_ = 0.0;
};

}  // namespace sinew::viewer
