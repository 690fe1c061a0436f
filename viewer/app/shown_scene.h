// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "runtime/model/scene_look.h"
#include "runtime/threads/job_thread.h"
#include "viewer/app/cache/cache_playback.h"
#include "viewer/app/camera/camera_pose.h"
#include "viewer/app/camera/frustum_culling.h"
#include "viewer/app/clip_extent.h"
#include "viewer/app/inspect/overlay_lines.h"
#include "viewer/app/loaded_scene.h"
#include "viewer/app/playback.h"
#include "viewer/app/update_levels.h"
#include "viewer/passes/frame_renderer.h"

namespace sinew::viewer {

/// The scene that plays in the window. Its poses come from the job thread; its vertices and materials are on the GPU.
class ShownScene {
 public:
  ShownScene(Device& device, const LoadedScene& loaded, const Evaluation& evaluation, std::uint32_t slot_count,
             const TextureFilter& filter);

  const LoadedScene& loaded() const noexcept { return loaded_; }
  const Needs& needs() const noexcept { return plan_.needs(); }
  std::span<const PlanStage> stages() const noexcept { return stages_; }
  const Evaluation& evaluation() const noexcept { return evaluation_; }
  const UpdateLevels& update_levels() const noexcept { return *levels_; }
  Playback& playback() noexcept { return playback_; }

  /// Stops the job thread. Afterwards only plan_for may be called.
  void stop() noexcept;

  /// Compiles a new plan and waits for its first pose, so that a pose is always available.
  void plan_for(const Evaluation& evaluation);

  /// Motion of the next pose. Until the plan has the shape of it (Evaluation::motion), the chosen clip plays alone.
  void set_motion(const MotionSettings& settings);

  /// The graph that drives the character; null = clips play. Valid until the next request.
  GraphPlayer* graph() noexcept { return motion_.graph(); }
  /// The pose program of the last request; empty while the clip plays alone.
  PoseProgramSpan program() const noexcept { return writes_program() ? motion_.program() : PoseProgramSpan{}; }

  /// Requests the pose of the current time and waits for it, so that the next picture shows it.
  void catch_up();

  /// Weight of the geometry cache in the next pose (FrameInput::geometry). Has no effect without a cache.
  void set_cache_weight(float weight) noexcept { cache_weight_ = weight; }
  /// Tells culling whether shadows are drawn, which meshes out of view may cast.
  void set_shadows(bool shadows) noexcept { shadows_ = shadows; }

  /// State of the geometry cache; empty without one.
  std::optional<CacheFacts> cache_facts() const;
  /// One sentence if the geometry cache cannot be shown; else empty.
  const std::string& cache_fault() const noexcept { return cache_fault_; }

  /// Requests the pose at the current time, with culling. Does nothing if that pose was already requested, or if the
  /// job thread is busy. Waits for the pose only if a mesh comes into view that the last request had culled.
  /// in   view            view of the next picture
  ///      view_is_moved   true if the clip moves the camera; then every frame is evaluated
  void submit(const View& view, bool view_is_moved, double aspect, bool joints_needed);

  /// The newest finished pose.
  const FrameResult& newest();
  /// True if the newest pose is the last requested one and shows exactly the current time.
  bool settled() const noexcept;

  /// True if settled() and nothing moves.
  bool resting() const noexcept { return settled() && (!playback_.playing() || playback_.duration_s() == 0.0); }

  /// Uploads the newest pose for one frame in flight. `variant` = kNone shows the default materials.
  DrawnScene upload(std::uint32_t slot, std::uint32_t variant);
  const UploadCounts& upload_counts() const noexcept { return frame_upload_.last_update(); }

  /// The view of a camera of the scene in the newest pose.
  /// in   aspect  width / height of the picture
  View view_of(std::uint32_t camera, double aspect);

  /// The view of that camera in the pose that the next request will evaluate.
  View coming_view_of(std::uint32_t camera, double aspect);

  /// True if a clip animates that camera.
  bool is_moved(std::uint32_t camera) { return camera_pose(camera).moves(); }
  std::span<const LineVertex> lines(const Inspected& inspected, bool skeleton);

  /// Bounds of the current clip; computed at its first use.
  const ClipExtent& bounds();

  ErrorCode last_error() const noexcept { return jobs_->last_error(); }

 private:
  struct Request {
    std::uint32_t clip = kNone;
    double time_s = 0.0;
    float cache_weight = 0.0f;
    std::uint64_t motion = 0;
    float fade = 1.0f;
    friend bool operator==(const Request&, const Request&) = default;
  };
  Request current() const noexcept;
  bool writes_program() const noexcept { return evaluation_.motion.writes_program && motion_.writes_program(); }
  void write_pose(FrameInput& input);
  MovedBy moved_by();
  void record_cache();
  bool is_requested() const noexcept { return request_is_exact_ && !swings_ && requested_ == current(); }
  void begin_frame(const View& view, bool view_is_moved);
  CameraPose& camera_pose(std::uint32_t camera);
  Result<Ticket> request();

  const LoadedScene& loaded_;
  Playback playback_;
  Evaluation evaluation_;
  std::optional<CachePlayback> cache_;  ///< must outlive the job thread, which calls it
  float cache_weight_ = 1.0f;
  bool shadows_ = false;
  Motion motion_;                     ///< must outlive the job thread, which runs its springs
  std::uint64_t motion_version_ = 0;  ///< counts changes of the motion's settings
  double since_request_s_ = 0.0;      ///< time that springs have to make up for
  bool swings_ = false;               ///< springs go on swinging
  bool cache_is_late_ = false;        ///< the newest pose shows an older cache frame, so it must be requested again
  std::string cache_fault_;
  Plan plan_;
  std::vector<PlanStage> stages_;  ///< stages of plan_
  std::unique_ptr<UpdateLevels> levels_;
  std::optional<CameraPose> camera_pose_;  ///< for the camera used last
  std::unique_ptr<JobThread> jobs_;
  JobThread::Character character_ = 0;
  Ticket ticket_ = 0;
  Request requested_;
  bool request_is_exact_ = false;  ///< false for an interpolated or held pose
  FrustumCulling culling_;
  CulledInstances culled_;            ///< for the next request
  CulledInstances requested_culled_;  ///< in the last request
  bool requested_joints_ = true, joints_needed_ = true;
  bool ready_seen_ = false;  ///< newest() was called after ticket_ finished
  const FrameResult* newest_ = nullptr;
  std::uint64_t plan_number_ = 0;  ///< source number for the upload: frame numbers restart with each plan
  SceneUpload scene_upload_;
  FrameUpload frame_upload_;
  SceneLook look_;
  OverlayLines lines_;
  std::vector<std::optional<ClipExtent>> bounds_;  ///< [clips + 1]; the last entry is the rest pose
};

}  // namespace sinew::viewer
