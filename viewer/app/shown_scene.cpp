// SPDX-License-Identifier: MIT
#include "viewer/app/shown_scene.h"

#include "runtime/base/contract.h"
#include "viewer/app/file_camera.h"

namespace sinew::viewer {

ShownScene::ShownScene(Device& device, const Exhibit& exhibit, Skinning skinning, bool stage_times, std::uint32_t slot_count)
    : exhibit_(exhibit),
      playback_(exhibit.scene),
      scene_upload_(device, exhibit.scene, slot_count),
      frame_upload_(device, exhibit.scene, slot_count),
      look_(exhibit.scene),
      skeleton_(exhibit.scene),
      bounds_(exhibit.scene.animations.size() + 1) {
  plan_for(skinning, stage_times);
}

void ShownScene::stop() noexcept {
  jobs_.reset();   // before the plan that it runs
  newest_ = nullptr;
}

void ShownScene::plan_for(Skinning skinning, bool stage_times) {
  stop();
  plan_ = std::make_unique<Plan>(compile_plan(exhibit_.scene, needs_of(exhibit_, skinning, stage_times)));
  ++plan_number_;
  jobs_ = std::make_unique<JobThread>();
  character_ = jobs_->add_character(*plan_);
  ready_seen_ = false;
  FrameInput input;
  input.layers = playback_.layers();
  const auto ticket = jobs_->submit({&input, 1});
  CONTRACT(ticket.has_value());   // nothing else was submitted
  ticket_ = *ticket;
  asked_ = current();
  jobs_->wait(ticket_);
  newest();
  CONTRACT(newest_ != nullptr);
}

void ShownScene::submit() {
  if (asked_ == current()) return;
  FrameInput input;
  input.layers = playback_.layers();
  const auto ticket = jobs_->submit({&input, 1});
  if (!ticket) return;   // busy: the next frame asks again
  ticket_ = *ticket;
  asked_ = current();
  ready_seen_ = false;
}

const FrameResult& ShownScene::newest() {
  const bool ready = jobs_->done(ticket_);
  newest_ = jobs_->latest(character_);
  ready_seen_ = ready_seen_ || ready;
  return *newest_;
}

bool ShownScene::settled() const noexcept { return ready_seen_ && asked_ == current(); }

DrawnScene ShownScene::upload(std::uint32_t slot, std::uint32_t variant) {
  frame_upload_.update(slot, newest(), plan_number_);
  scene_upload_.update(slot, frame_upload_.look(slot));
  return {&scene_upload_, &frame_upload_, variant};
}

View ShownScene::view_of(std::uint32_t camera_index, double aspect) {
  const FrameResult& pose = newest();
  apply_properties(exhibit_.scene, pose.properties, look_);
  const Camera& camera = look_.cameras[camera_index];
  return view_of_camera(camera, pose.model[camera.joint], aspect, bounds().reached);
}

std::span<const LineVertex> ShownScene::skeleton_lines() {
  return skeleton_.make(newest_->model, skeleton_.axis_length_m(bounds().largest));
}

const ClipBounds& ShownScene::bounds() {
  const std::uint32_t clip = playback_.clip();
  auto& known = clip < exhibit_.scene.animations.size() ? bounds_[clip] : bounds_.back();
  if (!known) known = clip_bounds(exhibit_.scene, clip);
  return *known;
}

}  // namespace sinew::viewer
