// SPDX-License-Identifier: MIT
#include "viewer/app/live_plan.h"

#include <algorithm>
#include <cstdio>

namespace sinew::viewer {

std::string_view title_of(PlanPart part) noexcept {
  switch (part) {
    case PlanPart::evaluation: return "evaluation, on the CPU";
    case PlanPart::drawing: return "drawing, on the CPU";
    case PlanPart::modes: return "modes of the picture";
    case PlanPart::passes: break;
  }
  return "passes, on the GPU";
}

PlanRow& LivePlan::row(PlanPart part, std::string_view stage) {
  for (PlanRow& row : rows_)
    if (row.part == part && row.stage == stage) return row;
  const auto behind = std::find_if(rows_.begin(), rows_.end(), [&](const PlanRow& row) { return row.part > part; });
  return *rows_.insert(behind, PlanRow{.part = part, .stage = std::string(stage)});
}

void LivePlan::tell(PlanPart part, std::string_view stage, bool runs, std::string_view reason, std::uint64_t count) {
  PlanRow& told = row(part, stage);
  told.runs = runs;
  told.reason = reason;
  told.count = count;
  if (!runs) {
    told.timed = 0;
    told.time_us = 0.0;
  }
}

void LivePlan::time(PlanPart part, std::string_view stage, double time_us) {
  PlanRow& timed = row(part, stage);
  timed.time_us = ++timed.timed > kWarmUpFrames ? timed.time_us + kSmoothing * (time_us - timed.time_us) : time_us;
}

void LivePlan::evaluated(std::span<const PlanStage> stages, const FrameResult& frame, bool resting) {
  const bool is_new = frame.frame != evaluated_frame_;
  if (!is_new && !resting) return;
  resting = !is_new;  // the frame of the first picture that rests was evaluated for it
  evaluated_frame_ = frame.frame;
  for (std::size_t s = 0; s < stages.size(); ++s) {
    const PlanStage& stage = stages[s];
    const bool exact = stage.stage == "interpolate" && frame.work.poses_interpolated == 0;
    const bool runs = stage.runs && !resting && !exact;
    const std::string_view reason = !stage.runs ? std::string_view(stage.reason)
                                    : resting   ? "nothing moves: the last pose stays"
                                    : exact     ? "this frame is evaluated, not one in between"
                                                : std::string_view(stage.reason);
    tell(PlanPart::evaluation, stage.stage, runs, reason, runs ? stage.count : 0);
    if (runs && s < frame.stage_ns.size())
      time(PlanPart::evaluation, stage.stage, 1e-3 * static_cast<double>(frame.stage_ns[s]));
  }
}

void LivePlan::updates(const UpdateLevels& levels) {
  tell(PlanPart::evaluation, "update rate", levels.level() != UpdateLevel::every, levels.reason(),
       std::uint64_t{1} << static_cast<unsigned>(levels.level()));
}

void LivePlan::cache(const CacheFacts& facts, const WorkCounters& work) {
  const std::string blended =
      work.vertices_blended > 0 ? ", " + std::to_string(work.vertices_blended) + " blended with the pose" : "";
  tell(PlanPart::evaluation, "cache window", work.cache_frames_decoded > 0,
       std::to_string(work.cache_frames_decoded) + " frames decoded, " + std::to_string(work.vertices_from_cache) +
           " vertices" + blended + "; " + describe_window(facts) + "; " + describe_cost(facts),
       work.cache_frames_decoded);
}

namespace {

std::string why_upload(const UploadCounts& upload) {
  if (upload.written > 0) {
    const std::string others =
        upload.unchanged > 0 ? ", " + std::to_string(upload.unchanged) + " are there unchanged" : "";
    return std::to_string(upload.bytes) + " bytes of deformed vertices" + others;
  }
  return upload.unchanged > 0 ? "all deformed vertices are there unchanged" : "nothing new is deformed";
}

std::string why_collect(const FrameReport& report) {
  return std::to_string(report.out_of_view) + " meshes out of view and " + std::to_string(report.hidden) +
         " hidden are left out";
}

}  // namespace

void LivePlan::presented(const WindowTimes& times) {
  const auto row = [&](std::string_view stage, std::string_view reason, double time_us) {
    tell(PlanPart::drawing, stage, true, reason, 1);
    time(PlanPart::drawing, stage, time_us);
  };
  row("panel", "lays out and records the panel", times.panel_us);
  row("wait", "for an earlier picture on the GPU, and for the display", times.wait_us);
  row("present", "hands the picture over to the display", times.present_us);
}

void LivePlan::drawn(const UploadCounts& upload, const FrameReport& report, std::span<const PassTime> passes) {
  tell(PlanPart::drawing, "upload", upload.written > 0, why_upload(upload), upload.written);
  if (upload.written > 0) time(PlanPart::drawing, "upload", upload.time_us);
  tell(PlanPart::drawing, "collect", true, why_collect(report), report.drawn);
  time(PlanPart::drawing, "collect", report.collect_us);
  for (const PictureMode& mode : report.modes)
    if (!mode.mode.empty()) tell(PlanPart::modes, mode.mode, mode.runs, mode.reason, mode.count);
  for (const PassStage& stage : report.passes)
    tell(PlanPart::passes, name_of(stage.pass), stage.runs, stage.reason, stage.count);
  // Times are of an earlier picture, in which other passes may have run.
  for (const PassTime& pass : passes)
    if (row(PlanPart::passes, pass.pass).runs) time(PlanPart::passes, pass.pass, 1e3 * pass.milliseconds);
}

std::string plan_text(std::span<const PlanRow> rows) {
  std::size_t widest = 0;
  for (const PlanRow& row : rows) widest = std::max(widest, row.stage.size());
  std::string text;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const PlanRow& row = rows[i];
    if (i > 0 && rows[i - 1].part != row.part) text += '\n';
    if (i == 0 || rows[i - 1].part != row.part) text.append(title_of(row.part)).append(1, '\n');
    char numbers[64];
    std::snprintf(numbers, sizeof(numbers),
                  row.timed > 0 ? "  %-3s %10llu %10.1f us  " : "  %-3s %10llu                ",
                  row.runs ? "on" : "off", static_cast<unsigned long long>(row.count), row.time_us);
    text.append(2, ' ').append(row.stage).append(widest - row.stage.size(), ' ');
    text.append(numbers).append(row.reason).append(1, '\n');
  }
  return text;
}

}  // namespace sinew::viewer
