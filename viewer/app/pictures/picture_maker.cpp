// SPDX-License-Identifier: MIT
#include "viewer/app/pictures/picture_maker.h"

#include <algorithm>
#include <cmath>

#include "viewer/app/camera/framed_camera.h"
#include "viewer/app/headless_run.h"
#include "viewer/upload/visibility_blend.h"

namespace sinew::viewer {
namespace {

OrbitCamera camera_for(const Options& options, const LoadedScene& loaded, const Outline& outline) {
  OrbitCamera camera = opening_camera(loaded, options);
  camera.frame(outline.points(), static_cast<double>(options.width) / options.height);
  return camera;
}

/// The motion of the character besides its clip, until the last picture.
MovedBy moved_by(const Options& options, const LoadedScene& loaded) {
  MovedBy moved{loaded.rig, settings_from(options, loaded.scene).motion};
  if ((loaded.rig && loaded.rig->graph) || options.root == RootPlay::moving)
    moved.duration_s = options.frames ? options.frames->last / options.fps : options.time_s.value_or(0.0);
  return moved;
}

/// Empty for Framing::clip, where the clip's own outline is framed.
std::optional<Framed> framed_for(const Options& options, const LoadedScene& loaded, std::uint32_t clip,
                                 const MovedBy& moved) {
  if (options.framing == Framing::clip) return std::nullopt;
  const double duration =
      std::max(clip == kNone ? 0.0 : loaded.scene.animations[clip].duration_s, cache_duration_s(loaded));
  return framed(options.framing, loaded.scene, clip, first_time_s(options, duration), loaded.cache.get(), &moved);
}

/// A view from a placed camera, which bypasses OrbitCamera: that cannot look straight down.
View placed_view(const PlacedCamera& placed, double fov_y_rad, const Aabb& reached, double turn_rad) {
  const glm::dvec3 target(placed.target), arm = glm::dvec3(placed.eye) - target;
  const double c = std::cos(turn_rad), s = std::sin(turn_rad);
  const glm::dvec3 eye = target + glm::dvec3(c * arm.x + s * arm.z, arm.y, c * arm.z - s * arm.x);
  const glm::dvec3 at = turn_rad == 0.0 ? glm::dvec3(placed.eye) : eye;
  return look_at(at, placed.target, fov_y_rad, near_plane_for(at, reached));
}

}  // namespace

double first_time_s(const Options& options, double duration_s) {
  return options.frames ? picture_time_s(options.frames->first, options.fps, duration_s) : options.time_s.value_or(0.0);
}

PictureMaker::PictureMaker(Device& device, const Options& options, const LoadedScene& loaded, std::uint32_t clip)
    : clip_(clip),
      moved_(moved_by(options, loaded)),
      bounds_(clip_extent(loaded.scene, clip, loaded.cache.get(), &moved_)),
      framed_(framed_for(options, loaded, clip, moved_)),
      placed_(options.camera ? options.camera : loaded.camera),
      framing_(camera_for(options, loaded, framed_ ? framed_->outline : bounds_.outline)),
      settings_(settings_from(options, loaded.scene)),
      environment_(loaded.environment),
      transparent_(options.transparent),
      shows_plan_(options.plan),
      frame_s_(1.0 / options.fps),
      aspect_(static_cast<double>(options.width) / options.height),
      evaluator_(loaded,
                 {settings_.skinning, settings_.updates, options.plan, shape_of(settings_.motion, loaded.rig.get())},
                 settings_, clip),
      culling_(loaded.scene, evaluator_.needs(),
               loaded.cache ? loaded.cache->reach(loaded.scene) : std::vector<Aabb>()),
      shadow_(shadow_sweep(loaded.scene, settings_.shadows, bounds_.reached, environment_.get())),
      lines_(loaded),
      visibility_(loaded.visibility),
      headless_(device, loaded.scene, options.width, options.height, {}, visibility_.get(), options.filter) {
  if (settings_.camera != kNone) camera_.emplace(loaded.scene, settings_.camera);
  view_ = view_at(first_time_s(options, 0.0), 0.0);
}

Picture PictureMaker::at(double time_s, double turn_rad) {
  evaluator_.levels().begin_exact_frame("one picture");
  if (evaluator_.motion().has_springs()) evaluator_.swing_to(time_s);
  return draw(time_s, time_s, 0.0, turn_rad, [time_s](std::uint32_t) { return time_s; });
}

Picture PictureMaker::in_sequence(std::uint32_t picture, const std::function<double(std::uint32_t)>& time_of) {
  const double played_s = picture * frame_s_;
  const bool is_first = evaluator_.newest().frame == 0;
  if (is_first && evaluator_.motion().has_springs()) evaluator_.swing_to(played_s);
  if (is_first)
    evaluator_.levels().begin_exact_frame("the first picture");
  else if (evaluator_.cache() && settings_.cache_weight > 0.0f)
    evaluator_.levels().begin_exact_frame("a geometry cache plays");
  else if (evaluator_.motion().writes_program())
    evaluator_.levels().begin_exact_frame("layers, a graph or springs play");
  else if (camera_ && camera_->moves())
    evaluator_.levels().begin_exact_frame("the camera moves with the clip");
  else
    evaluator_.levels().begin_frame(size_in_picture(evaluator_.newest(), view_), frame_s_);
  return draw(time_of(picture), played_s, is_first ? 0.0 : frame_s_, 0.0,
              [&](std::uint32_t frames) { return time_of(picture + frames); });
}

RenderOptions PictureMaker::look() const {
  RenderOptions look = render_options(settings_, environment_, bounds_, eye_of(view_));
  look.transparent_background = transparent_;
  return look;
}

void PictureMaker::frame_like(const PictureMaker& other) {
  bounds_ = other.bounds_;
  framed_ = other.framed_;
  framing_ = other.framing_;
}

View PictureMaker::view_at(double time_s, double turn_rad) {
  if (camera_) return camera_->at(clip_, time_s, aspect_, bounds_.reached);
  if (placed_ && !framed_) return placed_view(*placed_, framing_.fov_y_rad, bounds_.reached, turn_rad);
  OrbitCamera camera = framing_;
  if (framed_) camera.target += framed_->offset_at(time_s);
  camera.yaw_rad += turn_rad;
  return camera.view(bounds_.reached);
}

Picture PictureMaker::draw(double time_s, double played_s, double dt_s, double turn_rad,
                           const std::function<double(std::uint32_t)>& ahead_s) {
  view_ = view_at(time_s, turn_rad);
  const CulledInstances culled =
      evaluator_.motion().writes_program() ? culling_.all_in_view() : culling_.of(clip_, view_, aspect_, shadow_);
  const FrameResult& pose = evaluator_.at(time_s, played_s, dt_s, ahead_s, culled, settings_.needs_joints());
  const auto lines =
      lines_.make(pose, settings_.inspected, settings_.skeleton,
                  {clip_, time_s, evaluator_.motion().writes_program() ? &moved_ : nullptr}, bounds_.largest);
  Picture picture =
      headless_.render(pose, view_, look(), lines, settings_.variant,
                       visibility_ ? visibility_blend(*visibility_, clip_, time_s) : VisibilityBlend{}, 1);
  if (shows_plan_) {
    live_plan_.updates(evaluator_.levels());
    live_plan_.evaluated(evaluator_.stages(), pose);
    if (evaluator_.cache()) live_plan_.cache(evaluator_.cache()->facts(), pose.work);
    live_plan_.drawn(headless_.upload_counts(), headless_.report(), headless_.pass_times());
  }
  return picture;
}

}  // namespace sinew::viewer
