// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "viewer/app/camera/camera_pose.h"
#include "viewer/app/camera/framing.h"
#include "viewer/app/camera/orbit_camera.h"
#include "viewer/app/clip_extent.h"
#include "viewer/app/headless.h"
#include "viewer/app/inspect/overlay_lines.h"
#include "viewer/app/live_plan.h"
#include "viewer/app/options.h"
#include "viewer/app/pictures/picture_source.h"
#include "viewer/app/pose_evaluator.h"

namespace sinew::viewer {

/// Renders pictures of one scene and clip, at any time.
class PictureMaker : public PictureSource {
 public:
  /// in   loaded  must outlive this;   clip  kNone = the rest pose
  /// err  DeviceError
  PictureMaker(Device& device, const Options& options, const LoadedScene& loaded, std::uint32_t clip);

  Picture at(double time_s, double turn_rad = 0.0) override;
  Picture in_sequence(std::uint32_t picture, const std::function<double(std::uint32_t)>& time_of) override;
  std::string fault() const override { return evaluator_.cache() ? evaluator_.cache()->fault() : std::string(); }

  const LivePlan& live_plan() const noexcept { return live_plan_; }

  /// Median time of an evaluation near a time of the clip, in microseconds, without drawing. Springs are left out.
  double evaluation_us(double time_s) const { return evaluator_.time_us(time_s); }

  /// The pose of the last picture, the view of it and its light, for other pictures of the same moment.
  const FrameResult& pose() const noexcept { return evaluator_.newest(); }
  const View& view() const noexcept { return view_; }
  RenderOptions look() const;

  /// Shows what another maker's camera frames, so that the pictures of both can be compared.
  void frame_like(const PictureMaker& other);

 private:
  Picture draw(double time_s, double played_s, double dt_s, double turn_rad,
               const std::function<double(std::uint32_t)>& ahead_s);
  View view_at(double time_s, double turn_rad);

  std::uint32_t clip_;
  MovedBy moved_;
  ClipExtent bounds_;
  std::optional<Framed> framed_;        ///< unset = the whole clip is framed
  std::optional<PlacedCamera> placed_;  ///< set = neither clip nor pose is framed
  OrbitCamera framing_;
  View view_;
  Settings settings_;
  std::shared_ptr<const Environment> environment_;
  bool transparent_, shows_plan_;
  double frame_s_;  ///< time between pictures of a sequence
  double aspect_;
  PoseEvaluator evaluator_;
  FrustumCulling culling_;
  std::optional<glm::vec3> shadow_;
  std::optional<CameraPose> camera_;  ///< set if the picture is taken through one of the file's cameras
  OverlayLines lines_;
  std::shared_ptr<const VertexVisibility> visibility_;
  Headless headless_;
  LivePlan live_plan_;
};

/// Time of the first picture.
double first_time_s(const Options& options, double duration_s);

}  // namespace sinew::viewer
