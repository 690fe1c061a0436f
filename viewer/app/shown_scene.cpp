// SPDX-License-Identifier: MIT
#include "viewer/app/shown_scene.h"

#include <utility>

#include "runtime/base/contract.h"
#include "viewer/app/camera/file_camera.h"
#include "viewer/upload/visibility_blend.h"

namespace sinew::viewer {
namespace {

FrustumCulling culling_for(const LoadedScene& loaded, const Needs& needs) {
  return {loaded.scene, needs, loaded.cache ? loaded.cache->reach(loaded.scene) : std::vector<Aabb>()};
}

constexpr double kLongestGraph_s = 3600.0;

/// A graph plays for as long as the window is open, on a clock without a clip.
Playback playback_of(const LoadedScene& loaded) {
  if (!loaded.rig || !loaded.rig->graph) return Playback(loaded.scene, cache_duration_s(loaded));
  Playback playback(loaded.scene, kLongestGraph_s);
  playback.choose(kNone);
  playback.set_mode(PlayMode::clamp);
  return playback;
}

}  // namespace

ShownScene::ShownScene(Device& device, const LoadedScene& loaded, const Evaluation& evaluation,
                       std::uint32_t slot_count, const TextureFilter& filter)
    : loaded_(loaded),
      playback_(playback_of(loaded)),
      motion_(loaded.scene, loaded.rig, {}),
      culling_(culling_for(loaded, needs_of(loaded, evaluation))),
      culled_(culling_.all_in_view()),
      scene_upload_(device, loaded.scene, slot_count, loaded.visibility.get(), filter),
      frame_upload_(device, loaded.scene, slot_count),
      look_(loaded.scene),
      lines_(loaded),
      bounds_(loaded.scene.animations.size() + 1) {
  if (loaded.cache) cache_.emplace(*loaded.cache, loaded.scene, CacheReader::Reads::on_thread);
  plan_for(evaluation);
}

void ShownScene::stop() noexcept {
  jobs_.reset();  // the job thread uses the plan, so it must end before the plan changes
  newest_ = nullptr;
}

void ShownScene::plan_for(const Evaluation& evaluation) {
  stop();
  evaluation_ = evaluation;
  plan_ = compile_plan(lend(loaded_.scene), needs_of(loaded_, evaluation));
  stages_ = plan_.stages();
  levels_ = std::make_unique<UpdateLevels>(plan_, evaluation.updates);
  levels_->begin_exact_frame("the first");
  ++plan_number_;
  jobs_ = std::make_unique<JobThread>();
  character_ = jobs_->add_character(plan_);
  ready_seen_ = false;
  culling_ = culling_for(loaded_, plan_.needs());
  culled_ = culling_.all_in_view();
  catch_up();
}

void ShownScene::set_motion(const MotionSettings& settings) {
  playback_.set_fade(static_cast<double>(settings.fade_s));
  if (motion_.settings() == settings) return;
  if (newest_ != nullptr) jobs_->wait(ticket_);  // the job may run springs
  if (shape_of(settings, loaded_.rig.get()) != motion_.shape() || settings.root != motion_.settings().root)
    bounds_.assign(bounds_.size(), std::nullopt);
  motion_.set(settings);
  ++motion_version_;
}

ShownScene::Request ShownScene::current() const noexcept {
  return {playback_.clip(), playback_.time_s(), cache_ ? cache_weight_ : 0.0f, motion_version_,
          playback_.moment().fade};
}

void ShownScene::catch_up() {
  motion_.reset_springs();
  if (newest_ != nullptr) {
    jobs_->wait(ticket_);
    levels_->begin_exact_frame("the time was set");
  }
  const auto ticket = request();
  CONTRACT(ticket.has_value());  // the job thread is idle
  jobs_->wait(ticket_);
  newest();
  CONTRACT(newest_ != nullptr);
}

Result<Ticket> ShownScene::request() {
  FrameInput now;
  write_pose(now);
  if (cache_) now.geometry = cache_->at(playback_.time_s(), cache_weight_);
  apply_culling(culled_, joints_needed_, now);
  const FrameInput input =
      writes_program() ? now : levels_->input(now, playback_.layers_ahead(levels_->frames_to_update()));
  const auto ticket = jobs_->submit({&input, 1});
  if (!ticket) return ticket;
  ticket_ = *ticket;
  requested_ = current();
  request_is_exact_ = input.interpolation_factor == 0.0f && same_layers(input.layers, now.layers);
  requested_culled_ = culled_;
  requested_joints_ = joints_needed_;
  ready_seen_ = false;
  return ticket;
}

void ShownScene::write_pose(FrameInput& input) {
  if (motion_.settings().morph_weights.size() == loaded_.scene.weight_count())
    input.weights = motion_.settings().morph_weights;
  if (!writes_program()) {
    input.layers = playback_.layers();
    return;
  }
  if (newest_ != nullptr) jobs_->wait(ticket_);  // it may run the springs of the frame before
  MotionMoment moment = playback_.moment();
  moment.dt_s = std::exchange(since_request_s_, 0.0);
  motion_.write(moment, input);
}

void ShownScene::begin_frame(const View& view, bool view_is_moved) {
  if (!playback_.playing())
    levels_->begin_exact_frame("the time stands still");
  else if (cache_ && cache_weight_ > 0.0f)
    levels_->begin_exact_frame("a geometry cache plays");
  else if (writes_program())
    levels_->begin_exact_frame("layers, a graph or springs play");
  else if (view_is_moved)
    levels_->begin_exact_frame("the camera moves with the clip");
  else
    levels_->begin_frame(size_in_picture(*newest_, view), playback_.last_step_s());
}

void ShownScene::submit(const View& view, bool view_is_moved, double aspect, bool joints_needed) {
  begin_frame(view, view_is_moved);
  since_request_s_ += playback_.last_step_s();
  culled_ = writes_program()
                ? culling_.all_in_view()  // bounds of clips do not hold for mixed ones
                : culling_.of(playback_.clip(), view, aspect,
                              shadow_sweep(loaded_.scene, shadows_, bounds().reached, loaded_.environment.get()));
  joints_needed_ = joints_needed || !loaded_.scene.cameras.empty();  // the user may switch to one of them at any time
  const bool lacks = requested_culled_.culls_more_than(culled_) ||
                     (requested_culled_.every_instance && !requested_joints_ && joints_needed_);
  if (!lacks && is_requested() && !cache_is_late_) return;
  if (!request()) {
    if (!lacks) return;  // the worker is busy: the next frame requests again
    jobs_->wait(ticket_);
    CONTRACT(request().has_value());
  }
  if (lacks) jobs_->wait(ticket_);
}

const FrameResult& ShownScene::newest() {
  const bool ready = jobs_->done(ticket_);
  newest_ = jobs_->latest(character_);
  if (ready && !ready_seen_ && cache_) record_cache();
  if (ready && !ready_seen_) swings_ = writes_program() && playback_.playing() && motion_.is_swinging();
  ready_seen_ = ready_seen_ || ready;
  return *newest_;
}

// Reads the state of the cache. Called only while no job runs: the last request is done.
void ShownScene::record_cache() {
  cache_->watch(*newest_);
  cache_fault_ = cache_->fault();
  cache_is_late_ = is_late(*newest_) && cache_fault_.empty();
}

bool ShownScene::settled() const noexcept { return ready_seen_ && is_requested() && !cache_is_late_; }

std::optional<CacheFacts> ShownScene::cache_facts() const {
  if (!cache_) return std::nullopt;
  CacheFacts facts = cache_->facts();
  facts.fault = cache_fault_;
  if (resting()) facts.bytes_per_s = 0.0;
  return facts;
}

DrawnScene ShownScene::upload(std::uint32_t slot, std::uint32_t variant) {
  frame_upload_.update(slot, newest(), plan_number_);
  scene_upload_.update(slot, frame_upload_.look(slot));
  const VisibilityBlend visibility = loaded_.visibility
                                         ? visibility_blend(*loaded_.visibility, playback_.clip(), playback_.time_s())
                                         : VisibilityBlend{};
  return {&scene_upload_, &frame_upload_, variant, visibility};
}

View ShownScene::view_of(std::uint32_t camera_index, double aspect) {
  const FrameResult& pose = newest();
  apply_properties(loaded_.scene, pose.properties, look_);
  const Camera& camera = look_.cameras[camera_index];
  return view_of_camera(camera, pose.model[camera.joint], aspect, bounds().reached);
}

CameraPose& ShownScene::camera_pose(std::uint32_t camera) {
  if (!camera_pose_ || camera_pose_->camera() != camera) camera_pose_.emplace(loaded_.scene, camera);
  return *camera_pose_;
}

View ShownScene::coming_view_of(std::uint32_t camera, double aspect) {
  return camera_pose(camera).at(playback_.clip(), playback_.time_s(), aspect, bounds().reached);
}

std::span<const LineVertex> ShownScene::lines(const Inspected& inspected, bool skeleton) {
  const MovedBy moved = moved_by();
  return lines_.make(newest(), inspected, skeleton,
                     {playback_.clip(), playback_.time_s(), writes_program() ? &moved : nullptr}, bounds().largest);
}

MovedBy ShownScene::moved_by() {
  constexpr double kGraphFramed_s = 4.0;  // how long a graph is played to frame it
  return {loaded_.rig, motion_.settings(), motion_.graph() ? kGraphFramed_s : 0.0};
}

const ClipExtent& ShownScene::bounds() {
  const std::uint32_t clip = playback_.clip();
  auto& known = clip < loaded_.scene.animations.size() ? bounds_[clip] : bounds_.back();
  if (known) return *known;
  const MovedBy moved = moved_by();
  known = clip_extent(loaded_.scene, clip, loaded_.cache.get(), writes_program() ? &moved : nullptr);
  return *known;
}

}  // namespace sinew::viewer
