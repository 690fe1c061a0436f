// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "runtime/model/scene_look.h"
#include "runtime/threads/job_thread.h"
#include "viewer/app/cache/cache_playback.h"
#include "viewer/app/camera_pose.h"
#include "viewer/app/clip_extent.h"
#include "viewer/app/exhibit.h"
#include "viewer/app/frustum_culling.h"
#include "viewer/app/playback.h"
#include "viewer/app/skeleton_lines.h"
#include "viewer/app/update_levels.h"
#include "viewer/passes/frame_renderer.h"

namespace sinew::viewer {

/// One exhibit that plays in the window: its poses come from the job thread, its vertices and materials are on the GPU.
class ShownScene {
 public:
  ShownScene(Device& device, const Exhibit& exhibit, const Evaluation& evaluation, std::uint32_t slot_count,
             const TextureFilter& filter);

  const Exhibit& exhibit() const noexcept { return exhibit_; }
  const Needs& needs() const noexcept { return plan_.needs(); }
  std::span<const PlanStage> stages() const noexcept { return stages_; }
  const Evaluation& evaluation() const noexcept { return evaluation_; }
  const UpdateLevels& update_levels() const noexcept { return *levels_; }
  Playback& playback() noexcept { return playback_; }

  /// Ends the evaluation. After it, only plan_for may be called.
  void stop() noexcept;

  /// Compiles a new plan and waits for its first pose, so that there is always one to draw.
  void plan_for(const Evaluation& evaluation);

  /// Waits for the pose of the current time, so that the next picture shows it.
  void catch_up();

  /// How much of the geometry cache is in the next pose: FrameInput::geometry. Without one nothing changes.
  void set_cache_weight(float weight) noexcept { cache_weight_ = weight; }

  /// Shadows are drawn, so meshes out of view may matter.
  void set_shadows(bool shadows) noexcept { shadows_ = shadows; }

  /// The geometry cache as it plays; nothing without one.
  std::optional<CacheFacts> cache_facts() const;

  /// Why the geometry cache cannot be shown, in one sentence; empty when it can.
  const std::string& cache_fault() const noexcept { return cache_fault_; }

  /// Requests the pose at the current time, without meshes that are out of view. Does nothing if that pose was
  /// requested already, or while another request waits for the worker. Waits for the pose only if a mesh comes into
  /// view that the requested poses leave out.
  /// in   view            of the next picture
  ///      view_is_moved   the clip moves the camera: then every frame is evaluated
  void submit(const View& view, bool view_is_moved, double aspect, bool joints_watched);

  /// The newest pose that is ready.
  const FrameResult& newest();

  /// The newest pose is the one requested last, and is exactly that of the current time.
  bool settled() const noexcept;

  /// Settled, and the time does not advance.
  bool resting() const noexcept { return settled() && (!playback_.playing() || playback_.duration_s() == 0.0); }

  /// Uploads the newest pose to the slot.
  /// in   variant  of the scene's materials
  DrawnScene upload(std::uint32_t slot, std::uint32_t variant);

  const UploadCounts& upload_counts() const noexcept { return frame_upload_.last_update(); }

  /// The view of a camera of the scene in the newest pose.
  /// in   aspect  width / height of the picture
  View view_of(std::uint32_t camera, double aspect);

  /// Its view in the pose that is requested next.
  View coming_view_of(std::uint32_t camera, double aspect);

  /// A clip animates that camera.
  bool is_moved(std::uint32_t camera) { return camera_pose(camera).moves(); }

  std::span<const LineVertex> skeleton_lines();

  /// Extent of the current clip; computed once for each clip.
  const ClipExtent& bounds();

  ErrorCode last_error() const noexcept { return jobs_->last_error(); }

 private:
  struct Request {
    std::uint32_t clip = kNone;
    double time_s = 0.0;
    float cache_weight = 0.0f;
    friend bool operator==(const Request&, const Request&) = default;
  };
  Request current() const noexcept { return {playback_.clip(), playback_.time_s(), cache_ ? cache_weight_ : 0.0f}; }
  void watch_cache();
  bool is_requested() const noexcept { return request_is_exact_ && requested_ == current(); }
  void begin_frame(const View& view, bool view_is_moved);
  CameraPose& camera_pose(std::uint32_t camera);
  Result<Ticket> request();

  const Exhibit& exhibit_;
  Playback playback_;
  Evaluation evaluation_;
  std::optional<CachePlayback> cache_;  ///< outlives the job thread, which calls it
  float cache_weight_ = 1.0f;
  bool shadows_ = false;
  bool cache_is_late_ = false;  ///< in the newest pose: it is asked for again
  std::string cache_fault_;
  Plan plan_;
  std::vector<PlanStage> stages_;  ///< of the plan
  std::unique_ptr<UpdateLevels> levels_;
  std::optional<CameraPose> camera_pose_;  ///< of the camera that was used last
  std::unique_ptr<JobThread> jobs_;
  JobThread::Character character_ = 0;
  Ticket ticket_ = 0;
  Request requested_;
  bool request_is_exact_ = false;  ///< false for an interpolated or held pose
  FrustumCulling culling_;
  CulledInstances culled_;            ///< in the next pose
  CulledInstances requested_culled_;  ///< in the pose requested last
  bool requested_joints_ = true, joints_watched_ = true;
  bool ready_seen_ = false;  ///< newest() was called after ticket_ was done
  const FrameResult* newest_ = nullptr;
  std::uint64_t plan_number_ = 0;  ///< distinguishes the frames of this plan from those of earlier plans
  SceneUpload scene_upload_;
  FrameUpload frame_upload_;
  SceneLook look_;
  SkeletonLines skeleton_;
  std::vector<std::optional<ClipExtent>> bounds_;  ///< [clips + 1], the last is the rest pose
};

}  // namespace sinew::viewer
