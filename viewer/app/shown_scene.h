// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "runtime/model/scene_look.h"
#include "runtime/threads/job_thread.h"
#include "viewer/app/camera_pose.h"
#include "viewer/app/clip_extent.h"
#include "viewer/app/exhibit.h"
#include "viewer/app/playback.h"
#include "viewer/app/sight.h"
#include "viewer/app/skeleton_lines.h"
#include "viewer/app/update_levels.h"
#include "viewer/passes/frame_renderer.h"

namespace sinew::viewer {

/// One exhibit being played in the window: its evaluation on the job thread, its place on the GPU, its clock.
class ShownScene {
 public:
  ShownScene(Device& device, const Exhibit& exhibit, const Evaluation& evaluation, std::uint32_t slot_count);

  const Exhibit& exhibit() const noexcept { return exhibit_; }
  const Needs& needs() const noexcept { return plan_.needs(); }
  std::span<const PlanStage> stages() const noexcept { return stages_; }
  const Evaluation& evaluation() const noexcept { return evaluation_; }
  const UpdateLevels& update_levels() const noexcept { return *levels_; }
  Playback& playback() noexcept { return playback_; }

  /// Ends the evaluation: until the next plan_for only that may be called.
  void stop() noexcept;

  /// Compiles the plan anew and waits for its first pose, so that no frame shows nothing.
  void plan_for(const Evaluation& evaluation);

  /// Asks for the pose at the playback's time without what the picture to come does not show, unless the worker still
  /// has one waiting or has that pose already. Waits only where something comes into view that no pose on the way has.
  /// in   view            of the picture, through a camera of the file that of the time
  ///      view_is_moved   by the clip: then every frame is evaluated
  void submit(const View& view, bool view_is_moved, double aspect, bool joints_watched);

  /// The newest pose that is ready, never null.
  const FrameResult& newest();

  /// The newest pose is the one asked for last, and is the current one.
  bool settled() const noexcept;

  /// Settled, and the time stands still.
  bool resting() const noexcept { return settled() && (!playback_.playing() || playback_.duration_s() == 0.0); }

  /// Fills the slot with the newest pose, in one of the scene's variants.
  DrawnScene upload(std::uint32_t slot, std::uint32_t variant);

  const UploadCounts& upload_counts() const noexcept { return frame_upload_.last_update(); }

  /// What a camera of the scene sees in the newest pose, in a picture of this shape.
  View view_of(std::uint32_t camera, double aspect);

  /// What it will see in the pose that is asked for next.
  View coming_view_of(std::uint32_t camera, double aspect);

  /// A clip moves that camera, or changes what it sees.
  bool is_moved(std::uint32_t camera) { return camera_pose(camera).moves(); }

  std::span<const LineVertex> skeleton_lines();

  /// Of the clip that plays now; worked out once for each clip.
  const ClipExtent& bounds();

  ErrorCode last_error() const noexcept { return jobs_->last_error(); }

 private:
  struct Asked {
    std::uint32_t clip = kNone;
    double time_s = 0.0;
    friend bool operator==(const Asked&, const Asked&) = default;
  };
  Asked current() const noexcept { return {playback_.clip(), playback_.time_s()}; }
  bool has_asked() const noexcept { return asked_exactly_ && asked_ == current(); }
  void begin_frame(const View& view, bool view_is_moved);
  CameraPose& camera_pose(std::uint32_t camera);
  Result<Ticket> ask();

  const Exhibit& exhibit_;
  Playback playback_;
  Evaluation evaluation_;
  Plan plan_;
  std::vector<PlanStage> stages_;  ///< of the plan
  std::unique_ptr<UpdateLevels> levels_;
  std::optional<CameraPose> camera_pose_;  ///< of the camera that was looked through last
  std::unique_ptr<JobThread> jobs_;
  JobThread::Character character_ = 0;
  Ticket ticket_ = 0;
  Asked asked_;
  bool asked_exactly_ = false;  ///< not for a pose that stands in for the current one
  Sight sight_;
  Unseen unseen_;        ///< what the next pose leaves out
  Unseen asked_unseen_;  ///< what the one asked for last does
  bool asked_joints_ = true, joints_watched_ = true;
  bool ready_seen_ = false;  ///< newest() was called after ticket_ was done
  const FrameResult* newest_ = nullptr;
  std::uint64_t plan_number_ = 0;  ///< tells the frames of one plan from those of the last
  SceneUpload scene_upload_;
  FrameUpload frame_upload_;
  SceneLook look_;
  SkeletonLines skeleton_;
  std::vector<std::optional<ClipExtent>> bounds_;  ///< [clips + 1], the last is the rest pose
};

}  // namespace sinew::viewer
