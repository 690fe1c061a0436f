// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "runtime/base/contract.h"
#include "runtime/plan/run_plan.h"
#include "viewer/app/cache/cache_playback.h"
#include "viewer/app/camera/frustum_culling.h"
#include "viewer/app/loaded_scene.h"
#include "viewer/app/settings.h"
#include "viewer/app/update_levels.h"

namespace sinew::viewer {

/// Evaluates the pose of a scene at any time, on the calling thread.
class PoseEvaluator {
 public:
  PoseEvaluator(const LoadedScene& loaded, const Evaluation& evaluation, const Settings& settings, std::uint32_t clip)
      : scene_(loaded.scene),
        clip_(clip),
        cache_weight_(settings.cache_weight),
        motion_(loaded.scene, loaded.rig, settings.motion),
        plan_(compile_plan(lend(loaded.scene), needs_of(loaded, evaluation))),
        stages_(plan_.stages()),
        frame_(plan_),
        levels_(plan_, evaluation.updates) {
    if (loaded.cache) cache_.emplace(*loaded.cache, loaded.scene, CacheReader::Reads::blocking);
  }

  const Needs& needs() const noexcept { return plan_.needs(); }
  std::span<const PlanStage> stages() const noexcept { return stages_; }
  const FrameResult& newest() const noexcept { return frame_.result(); }
  UpdateLevels& levels() noexcept { return levels_; }
  const CachePlayback* cache() const noexcept { return cache_ ? &*cache_ : nullptr; }
  Motion& motion() noexcept { return motion_; }

  /// in   ahead_s  returns the clip time of the picture N frames after this one
  ///      played_s  time since the start, over all rounds of the clip;   dt_s  since the picture before
  const FrameResult& at(double time_s, double played_s, double dt_s,
                        const std::function<double(std::uint32_t)>& ahead_s, const CulledInstances& culled,
                        bool joints_needed) {
    const ClipLayer layer{clip_, time_s, 1.0f}, ahead{clip_, ahead_s(levels_.frames_to_update()), 1.0f};
    const std::size_t count = clip_ != kNone;
    FrameInput now;
    apply_culling(culled, joints_needed, now);
    if (!motion_.writes_program()) now.layers = {&layer, count};
    if (cache_) now.geometry = cache_->at(time_s, cache_weight_);
    if (motion_.writes_program()) {
      MotionMoment moment = moment_at(scene_, clip_, played_s);
      moment.dt_s = dt_s;
      motion_.write(moment, now);
    }
    const ErrorCode code =
        run_plan(plan_, motion_.writes_program() ? now : levels_.input(now, {&ahead, count}), frame_);
    CONTRACT(code == ErrorCode::ok);  // the clip is in range and the time is finite
    if (cache_) cache_->watch(frame_.result());
    return frame_.result();
  }

  /// Plays from the start to a time without pictures, so that springs swing as they would have until then.
  void swing_to(double played_s) {
    constexpr double kTick_s = 1.0 / 60.0;
    motion_.reset_springs();
    const auto ticks = static_cast<std::uint64_t>(std::floor(played_s / kTick_s));
    for (std::uint64_t tick = 0; tick <= ticks; ++tick) {
      FrameInput now;
      MotionMoment moment = moment_at(scene_, clip_, static_cast<double>(tick) * kTick_s);
      moment.dt_s = tick == 0 ? 0.0 : kTick_s;
      motion_.write(moment, now);
      CONTRACT(run_plan(plan_, now, frame_) == ErrorCode::ok);
    }
  }

  /// Median of several evaluations near a time, each of another moment, in microseconds.
  double time_us(double time_s) const {
    constexpr int kRuns = 9;
    constexpr double kApart_s = 1e-3;
    MotionSettings settings = motion_.settings();
    settings.springs = false;
    Motion motion(scene_, motion_.rig(), settings);
    FrameBuffer frame(plan_);
    std::vector<double> times;
    for (int run = 0; run <= kRuns; ++run) {
      const MotionMoment moment = moment_at(scene_, clip_, std::max(time_s, 0.0) + run * kApart_s);
      const ClipLayer layer{clip_, moment.time_s, 1.0f};
      FrameInput now;
      if (motion.writes_program())
        motion.write(moment, now);
      else if (clip_ != kNone)
        now.layers = {&layer, 1};
      const auto start = std::chrono::steady_clock::now();
      CONTRACT(run_plan(plan_, now, frame) == ErrorCode::ok);
      const std::chrono::duration<double, std::micro> took = std::chrono::steady_clock::now() - start;
      if (run > 0) times.push_back(took.count());  // the first one fills caches
    }
    std::nth_element(times.begin(), times.begin() + kRuns / 2, times.end());
    return times[kRuns / 2];
  }

 private:
  const Scene& scene_;
  std::uint32_t clip_;
  float cache_weight_;
  Motion motion_;
  Plan plan_;
  std::vector<PlanStage> stages_;
  FrameBuffer frame_;
  UpdateLevels levels_;
  std::optional<CachePlayback> cache_;
};

}  // namespace sinew::viewer
