// SPDX-License-Identifier: MIT
#include "viewer/app/camera/framed_camera.h"

#include <numbers>
#include <utility>

namespace sinew::viewer {
namespace {

Framed framed_now(Framing framing, ShownScene& shown) {
  const LoadedScene& loaded = shown.loaded();
  const Playback& playback = shown.playback();
  return framed(framing, loaded.scene, playback.clip(), playback.time_s(), loaded.cache.get());
}

}  // namespace

OrbitCamera opening_camera(const LoadedScene& loaded, const Options& options) noexcept {
  OrbitCamera camera;
  camera.fov_y_rad = options.fov_y_deg ? *options.fov_y_deg * std::numbers::pi / 180.0 : loaded.fov_y_rad;
  camera.yaw_rad += loaded.facing_yaw_rad;
  return camera;
}

void FramedCamera::frame(Framing framing, ShownScene& shown, double aspect, const FreePart& free) {
  followed_.reset();
  free_ = free;
  if (framing == Framing::clip) return orbit.frame(shown.bounds().outline.points(), aspect, free);
  Framed what = framed_now(framing, shown);
  orbit.frame(what.outline.points(), aspect, free);
  if (framing != Framing::follow) return;
  place_ = glm::dvec3(0.0);
  follow_from(std::move(what), shown.playback());
}

void FramedCamera::follow(ShownScene& shown, double aspect) {
  if (!followed_) return;
  const Playback& playback = shown.playback();
  if (followed_clip_ != playback.clip()) return frame(Framing::follow, shown, aspect, free_);
  move_to(followed_->offset_at(playback.time_s()));
}

void FramedCamera::keep_following(ShownScene& shown) {
  if (followed_) follow_from(framed_now(Framing::follow, shown), shown.playback());
}

void FramedCamera::follow_from(Framed what, const Playback& playback) {
  move_to(what.offset_at(playback.time_s()));
  followed_ = std::move(what);
  followed_clip_ = playback.clip();
}

void FramedCamera::move_to(const glm::dvec3& place) {
  orbit.target += place - place_;
  place_ = place;
}

}  // namespace sinew::viewer
