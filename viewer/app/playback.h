// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <optional>
#include <span>

#include "runtime/model/scene.h"
#include "runtime/plan/run_plan.h"
#include "runtime/playback/playback_clock.h"
#include "viewer/app/motion/motion.h"

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
  /// If a fade is set, the clip before fades out while the new one plays.
  void choose(std::uint32_t clip);
  /// Duration of the cross-fade of choose(), in seconds of world time; 0 = none.
  void set_fade(double fade_s) noexcept { fade_s_ = fade_s; }
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
  void seek(double time_s) noexcept { clock_.seek(time_s - range_start_s_); }  ///< clamped to the range

  /// Pauses and moves to the next (+1) or previous (-1) multiple of kFrame_s, wrapping around in the range.
  void step(int direction) noexcept;

  /// The next speed up or down in .05 .1 .25 .5 .75 1 1.5 2 4 8.
  void faster() noexcept;
  void slower() noexcept;
  void set_speed(double speed) noexcept { clock_.set_speed(speed); }
  double speed() const noexcept { return clock_.speed(); }

  void set_mode(PlayMode mode);
  void next_mode();  ///< cycles through loop, ping-pong, once, and all clips in turn where there are several
  PlayMode mode() const noexcept { return clock_.mode(); }

  /// Plays the next clip at the end of each clip, or the previous one when played backwards. Clips without duration are
  /// skipped. set_mode() ends it.
  void play_in_turn();
  bool in_turn() const noexcept { return in_turn_; }

  /// Plays only this part of the clip; times are clamped to the clip. A part shorter than kFrame_s stands for the whole
  /// clip. Another clip is whole again.
  void set_range(double from_s, double to_s) noexcept;
  double range_start_s() const noexcept { return range_start_s_; }
  double range_end_s() const noexcept { return range_start_s_ + clock_.duration_s(); }
  bool has_range() const noexcept { return clock_.duration_s() < duration_s_; }

  double time_s() const noexcept { return range_start_s_ + clock_.time_s(); }
  double duration_s() const noexcept { return duration_s_; }  ///< of the whole clip

  /// The clip layers to evaluate: one, or none for the rest pose. Valid until this object changes.
  std::span<const ClipLayer> layers() noexcept;

  /// The moment to evaluate, with the clip that fades out. `dt_s` is not set.
  MotionMoment moment() const noexcept;
  bool fading() const noexcept { return faded_s_ < fade_s_; }

  /// Argument of the last advance(); 0 while paused.
  double last_step_s() const noexcept { return last_step_s_; }

  /// The clip layers `frames` frames from now, assuming that each frame lasts as long as the last one. Valid until this
  /// object changes.
  std::span<const ClipLayer> layers_ahead(std::uint32_t frames) noexcept;

 private:
  void begin_next_in_turn();

  const Scene* scene_;
  double least_duration_s_ = 0.0;
  std::uint32_t clip_ = kNone;
  bool playing_ = true, in_turn_ = false;
  double duration_s_ = 0.0, range_start_s_ = 0.0;
  PlaybackClock clock_;  ///< runs from the start of the range to its end
  ClipLayer layer_, ahead_;
  double last_step_s_ = 0.0;
  double fade_s_ = 0.0;
  double faded_s_ = 0.0;  ///< since the last choose(); beyond fade_s_ nothing fades
  std::uint32_t clip_before_ = kNone;
  double range_start_before_s_ = 0.0;
  PlaybackClock clock_before_{0.0};
};

}  // namespace sinew::viewer
