// SPDX-License-Identifier: MIT
#pragma once
#include <span>
#include <string>
#include <vector>

#include "runtime/plan/compile_plan.h"
#include "runtime/plan/frame_result.h"
#include "viewer/app/update_levels.h"
#include "viewer/passes/frame_renderer.h"

namespace sinew::viewer {

/// Where a row's work is done.
enum class PlanPart { evaluation, drawing, passes };

/// One stage from the clip to the picture: of the runtime's plan, of the viewer's own work, or a pass of the GPU.
struct PlanRow {
  PlanPart part = PlanPart::evaluation;
  std::string stage;
  bool runs = false;
  std::string reason;
  std::uint64_t count = 0;
  std::uint32_t timed = 0;  ///< frames that the time is of; 0 = not known
  double time_us = 0.0;     ///< smoothed over frames; 0 while the stage has nothing to do
};

/// "evaluation, on the CPU"
std::string_view title_of(PlanPart part) noexcept;

/// The plan as it runs: what each frame does, why, and how long it takes. Times are exponential means of the last
/// frames.
class LivePlan {
 public:
  static constexpr double kShare = 0.1;  ///< of the newest frame in the mean
  static constexpr std::uint32_t kFirst =
      3;  ///< frames that build what later ones use: the mean starts with the last of them

  /// A frame of a plan with these stages was evaluated. Frames that were seen before count once.
  /// in   frame   its stage_ns may be empty: then there are no times
  void evaluated(std::span<const PlanStage> stages, const FrameResult& frame);

  /// How often poses are evaluated, and why.
  void updates(const UpdateLevels& levels);

  /// A picture was drawn.
  void drawn(const UploadCounts& upload, const FrameReport& report, std::span<const PassTime> passes);

  std::span<const PlanRow> rows() const noexcept { return rows_; }

  /// Of another scene or plan.
  void forget() { rows_.clear(), evaluated_frame_ = 0; }

 private:
  PlanRow& row(PlanPart part, std::string_view stage);
  void tell(PlanPart part, std::string_view stage, bool runs, std::string_view reason, std::uint64_t count);
  void time(PlanPart part, std::string_view stage, double time_us);

  std::vector<PlanRow> rows_;
  std::uint64_t evaluated_frame_ = 0;
};

/// A table of text: stage, on or off, count, microseconds, reason.
std::string plan_text(std::span<const PlanRow> rows);

}  // namespace sinew::viewer
