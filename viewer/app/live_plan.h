// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string>
#include <vector>

#include "runtime/plan/compile_plan.h"
#include "runtime/plan/frame_result.h"
#include "viewer/app/cache/cache_facts.h"
#include "viewer/app/update_levels.h"
#include "viewer/passes/frame_renderer.h"

namespace sinew::viewer {

/// The section of the live plan that a row belongs to.
enum class PlanPart { evaluation, drawing, modes, passes };

/// One row of the live plan: a stage of the runtime's plan, CPU work of the viewer, a rendering mode, or a GPU pass.
struct PlanRow {
  PlanPart part = PlanPart::evaluation;
  std::string stage;
  bool runs = false;
  std::string reason;
  std::uint64_t count = 0;
  std::uint32_t timed = 0;  ///< number of frames measured; 0 = the time is unknown
  double time_us = 0.0;     ///< exponential moving average over frames; 0 while the stage does not run
};

/// Heading of a section, such as "evaluation, on the CPU".
std::string_view title_of(PlanPart part) noexcept;

/// CPU times of a picture in a window, in microseconds.
struct WindowTimes {
  double wait_us = 0.0;     ///< until the GPU has finished an earlier picture, and the display has an image to draw to
  double panel_us = 0.0;    ///< laying out and recording the panel
  double present_us = 0.0;  ///< handing the picture over to the display
};

/// Collects what each frame does, why, and how long it takes. Times are exponential moving averages over frames.
class LivePlan {
 public:
  static constexpr double kSmoothing = 0.1;  ///< weight of the newest frame in the mean
  static constexpr std::uint32_t kWarmUpFrames =
      3;  ///< the first frames fill caches; the average starts with the last of them

  /// Records an evaluated frame of a plan with these stages. Calling it again with the same frame has no effect, unless
  /// nothing moves any more: then no stage runs.
  /// in   frame   if its stage_ns is empty, no times are recorded
  ///      resting  no pose is evaluated, because nothing moves
  void evaluated(std::span<const PlanStage> stages, const FrameResult& frame, bool resting = false);

  /// Records the current update rate of the poses, and the reason for it.
  void updates(const UpdateLevels& levels);

  /// Records the state of the geometry cache and the work that the newest frame did with it.
  void cache(const CacheFacts& facts, const WorkCounters& work);

  /// Records what the window does for a picture besides drawing the scene.
  void presented(const WindowTimes& times);

  /// Records the upload and the render passes of a drawn picture.
  void drawn(const UploadCounts& upload, const FrameReport& report, std::span<const PassTime> passes);

  std::span<const PlanRow> rows() const noexcept { return rows_; }

  /// Removes all rows. Call it after the scene or the plan has changed.
  void forget() {
    rows_.clear();
    evaluated_frame_ = 0;
  }

 private:
  PlanRow& row(PlanPart part, std::string_view stage);
  void tell(PlanPart part, std::string_view stage, bool runs, std::string_view reason, std::uint64_t count);
  void time(PlanPart part, std::string_view stage, double time_us);

  std::vector<PlanRow> rows_;
  std::uint64_t evaluated_frame_ = 0;
};

/// The rows as a text table: stage, on or off, count, microseconds, reason.
std::string plan_text(std::span<const PlanRow> rows);

}  // namespace sinew::viewer
