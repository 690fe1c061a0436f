// SPDX-License-Identifier: MIT
#include "viewer/app/shown_scene.h"

#include "runtime/base/contract.h"
#include "viewer/app/file_camera.h"

namespace sinew::viewer {

ShownScene::ShownScene(Device& device, const Exhibit& exhibit, const Evaluation& evaluation, std::uint32_t slot_count)
    : exhibit_(exhibit),
      playback_(exhibit.scene),
      sight_(exhibit.scene, needs_of(exhibit, evaluation)),
      unseen_(sight_.nothing()),
      scene_upload_(device, exhibit.scene, slot_count),
      frame_upload_(device, exhibit.scene, slot_count),
      look_(exhibit.scene),
      skeleton_(exhibit.scene),
      bounds_(exhibit.scene.animations.size() + 1) {
  plan_for(evaluation);
}

void ShownScene::stop() noexcept {
  jobs_.reset();  // before the plan that it runs
  newest_ = nullptr;
}

void ShownScene::plan_for(const Evaluation& evaluation) {
  stop();
  evaluation_ = evaluation;
  plan_ = compile_plan(exhibit_.scene, needs_of(exhibit_, evaluation));
  stages_ = plan_.stages();
  levels_ = std::make_unique<UpdateLevels>(plan_, evaluation.updates);
  levels_->begin_exact_frame("the first");
  ++plan_number_;
  jobs_ = std::make_unique<JobThread>();
  character_ = jobs_->add_character(plan_);
  ready_seen_ = false;
  sight_ = Sight(exhibit_.scene, plan_.needs());
  unseen_ = sight_.nothing();
  const auto ticket = ask();
  CONTRACT(ticket.has_value());  // nothing else was submitted
  jobs_->wait(ticket_);
  newest();
  CONTRACT(newest_ != nullptr);
}

Result<Ticket> ShownScene::ask() {
  FrameInput now;
  now.layers = playback_.layers();
  leave_out(unseen_, joints_watched_, now);
  const FrameInput input = levels_->input(now, playback_.layers_ahead(levels_->frames_to_update()));
  const auto ticket = jobs_->submit({&input, 1});
  if (!ticket) return ticket;
  ticket_ = *ticket;
  asked_ = current(), asked_exactly_ = input.interpolation_factor == 0.0f && same_layers(input.layers, now.layers);
  asked_unseen_ = unseen_, asked_joints_ = joints_watched_;
  ready_seen_ = false;
  return ticket;
}

void ShownScene::begin_frame(const View& view, bool view_is_moved) {
  if (!playback_.playing())
    levels_->begin_exact_frame("the time stands still");
  else if (view_is_moved)
    levels_->begin_exact_frame("the camera moves with the clip");
  else
    levels_->begin_frame(size_in_picture(*newest_, view), playback_.last_step_s());
}

void ShownScene::submit(const View& view, bool view_is_moved, double aspect, bool joints_watched) {
  begin_frame(view, view_is_moved);
  unseen_ = sight_.of(playback_.clip(), view, aspect);
  joints_watched_ = joints_watched || !exhibit_.scene.cameras.empty();  // one of them may be chosen any time
  const bool lacks = asked_unseen_.hides_more_than(unseen_) || (asked_unseen_.all && !asked_joints_ && joints_watched_);
  if (!lacks && has_asked()) return;
  if (!ask()) {
    if (!lacks) return;  // busy: the next frame asks again
    jobs_->wait(ticket_);
    CONTRACT(ask().has_value());
  }
  if (lacks) jobs_->wait(ticket_);
}

const FrameResult& ShownScene::newest() {
  const bool ready = jobs_->done(ticket_);
  newest_ = jobs_->latest(character_);
  ready_seen_ = ready_seen_ || ready;
  return *newest_;
}

bool ShownScene::settled() const noexcept { return ready_seen_ && has_asked(); }

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

CameraPose& ShownScene::camera_pose(std::uint32_t camera) {
  if (!camera_pose_ || camera_pose_->camera() != camera) camera_pose_.emplace(exhibit_.scene, camera);
  return *camera_pose_;
}

View ShownScene::coming_view_of(std::uint32_t camera, double aspect) {
  return camera_pose(camera).at(playback_.clip(), playback_.time_s(), aspect, bounds().reached);
}

std::span<const LineVertex> ShownScene::skeleton_lines() {
  return skeleton_.make(newest_->model, skeleton_.axis_length_m(bounds().largest));
}

const ClipExtent& ShownScene::bounds() {
  const std::uint32_t clip = playback_.clip();
  auto& known = clip < exhibit_.scene.animations.size() ? bounds_[clip] : bounds_.back();
  if (!known) known = clip_extent(exhibit_.scene, clip);
  return *known;
}

}  // namespace sinew::viewer
