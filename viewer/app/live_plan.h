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

/// The part of a frame that a row belongs to.
enum class PlanPart { evaluation, drawing, modes, passes };

/// One stage between clip and picture: a stage of the runtime's plan, work of the viewer on the CPU, a choice of how
/// the picture is made, or a pass on the GPU.
struct PlanRow {
  PlanPart part = PlanPart::evaluation;
  std::string stage;
  bool runs = false;
  std::string reason;
  std::uint64_t count = 0;
  std::uint32_t timed = 0;  ///< frames measured so far; 0 = the time is not known
  double time_us = 0.0;     ///< exponential mean over frames; 0 while the stage does not run
};

/// "evaluation, on the CPU"
std::string_view title_of(PlanPart part) noexcept;

/// The plan as it runs: what each frame does, why, and how long it takes. Times are exponential means over frames.
class LivePlan {
 public:
  static constexpr double kSmoothing = 0.1;  ///< weight of the newest frame in the mean
  static constexpr std::uint32_t kWarmUpFrames =
      3;  ///< these build what later frames use; the mean starts with the last of them

  /// Records that a frame of a plan with these stages was evaluated. The same frame counts once.
  /// in   frame   without stage_ns there are no times
  void evaluated(std::span<const PlanStage> stages, const FrameResult& frame);

  /// Records how often poses are evaluated, and why.
  void updates(const UpdateLevels& levels);

  /// Records how a geometry cache plays, and what the newest frame took from it.
  void cache(const CacheFacts& facts, const WorkCounters& work);

  /// Records that a picture was drawn.
  void drawn(const UploadCounts& upload, const FrameReport& report, std::span<const PassTime> passes);

  std::span<const PlanRow> rows() const noexcept { return rows_; }

  /// Starts again, for another scene or plan.
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
