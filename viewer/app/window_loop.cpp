// SPDX-License-Identifier: MIT
#include "viewer/app/window_loop.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <thread>

#include "viewer/app/actions.h"
#include "viewer/app/bake_visibility.h"
#include "viewer/app/frame.h"
#include "viewer/app/framed_camera.h"
#include "viewer/app/headless_run.h"
#include "viewer/app/live_plan.h"
#include "viewer/app/log_line.h"
#include "viewer/app/panel/panel.h"
#include "viewer/app/reload/replace_shown_scene.h"
#include "viewer/app/scene_choice.h"
#include "viewer/app/validation_outcome.h"
#include "viewer/app/window.h"

namespace sinew::viewer {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kFramePeriod_s = 1.0 / 60.0;  // frame rate limit, because some drivers do not wait for the display
constexpr double kIdleWait_s = 0.1;            // longest wait for an event while nothing is animated
// Limit of a time step, so that the animation does not jump after the machine was suspended.
constexpr double kLongestStep_s = 0.25;
constexpr int kFramesAfterChange = 4;  // frames drawn after input, because ImGui reacts over several frames

double seconds_since(Clock::time_point then) { return std::chrono::duration<double>(Clock::now() - then).count(); }

DeviceOptions device_options(const Options& options, const Window& window) {
  DeviceOptions wanted;
  wanted.validation = options.validate;
  wanted.disk_cache = options.disk_cache;
  wanted.instance_extensions = window.instance_extensions();
  wanted.make_surface = [&window](VkInstance instance) { return window.make_surface(instance); };
  return wanted;
}

class WindowLoop {
 public:
  WindowLoop(const Options& options, std::vector<LoadedScene>& loaded_scenes, std::optional<std::uint32_t> clip,
             SceneReloader* watch)
      : options_(options),
        loaded_scenes_(loaded_scenes),
        watch_(watch),
        window_(options.width, options.height, "sinew"),
        device_(device_options(options, window_)),
        swapchain_(device_, window_.framebuffer_size()),
        panel_(device_, swapchain_, window_.handle()),
        frame_(device_, swapchain_, panel_),
        scene_index_(options.first_scene()),
        settings_(settings_from(options, loaded_scenes[options.first_scene()].scene)) {
    if (!options.smooth_edges && device_.is_software())
      settings_.smooth_edges = false;  // multisampling would take most of the frame time
    for (const auto& loaded : loaded_scenes) names_.push_back(loaded.name);
    switch_scene(options.first_scene(), clip, options.time_s);
  }

  int run();

 private:
  std::unique_ptr<ShownScene> make_shown(const LoadedScene& loaded, const Evaluation& evaluation) {
    return std::make_unique<ShownScene>(device_, loaded, evaluation, Frame::kSlots, options_.filter);
  }
  void switch_scene(std::uint32_t index, std::optional<std::uint32_t> clip, std::optional<double> time_s);
  void add_visibility(std::uint32_t clip);
  void adapt_to_light(std::uint32_t clip);
  void place_camera();
  void frame_all();
  void leave_file_camera();
  double aspect() const;
  void request_next_pose();
  void react(const Input& input);
  void act(Action action);
  bool fit_swapchain();
  void apply_requested_changes();
  PanelFacts facts();
  void draw();
  void limit_frame_rate();
  void report_error_once();
  void follow_file(double now_s);
  std::string show_changed(LoadedScene changed);

  const Options& options_;
  std::vector<LoadedScene>& loaded_scenes_;
  SceneReloader* watch_;  ///< null = files are not reloaded
  std::vector<std::string> names_;
  Window window_;
  Device device_;
  Swapchain swapchain_;
  PanelBackend panel_;
  Frame frame_;
  std::unique_ptr<ShownScene> shown_;
  std::uint32_t scene_index_ = 0;
  FramedCamera camera_;
  FreeWidth free_;                 ///< part of the window beside the panel
  bool camera_is_framed_ = false;  ///< the user has not moved the camera since it framed the scene
  Settings settings_;
  bool exposure_is_adapted_ = false;  ///< adapt_to_light() has switched automatic exposure on
  LivePlan live_plan_;
  std::optional<std::uint32_t> requested_scene_;
  int frames_to_draw_ = kFramesAfterChange;  // left before the loop pauses because nothing moves
  double frame_ms_ = 0.0;
  std::string reported_error_;
  std::string reload_fault_;  ///< why the changed file is not shown; empty = it is
  Clock::time_point last_look_ = Clock::now(), last_picture_ = last_look_, next_frame_ = last_look_;
};

void WindowLoop::switch_scene(std::uint32_t index, std::optional<std::uint32_t> clip, std::optional<double> time_s) {
  device_.wait_idle();
  if (index != scene_index_) settings_.camera = settings_.variant = kNone;  // these indices belong to the last scene
  scene_index_ = index;
  shown_.reset();  // frees GPU memory before the next scene is uploaded
  add_missing_centers(loaded_scenes_[index], settings_.skinning);
  add_visibility(clip.value_or(loaded_scenes_[index].scene.animations.empty() ? kNone : 0));
  adapt_to_light(clip.value_or(loaded_scenes_[index].scene.animations.empty() ? kNone : 0));
  shown_ = make_shown(loaded_scenes_[index], settings_.evaluation());
  live_plan_.forget();
  if (clip) shown_->playback().choose(*clip);
  if (time_s) shown_->playback().seek(*time_s);
  window_.set_title(loaded_scenes_[index].name + " - sinew");
  place_camera();
}

/// Lets exposure follow the picture if light would clip the scene, and no longer for the next scene.
void WindowLoop::adapt_to_light(std::uint32_t clip) {
  const LoadedScene& loaded = loaded_scenes_[scene_index_];
  if (exposure_is_adapted_) settings_.auto_exposure = options_.auto_exposure;
  const std::string why = adapt_exposure(device_, options_, loaded, clip);
  exposure_is_adapted_ = !why.empty();
  if (!exposure_is_adapted_) return;
  log_line(loaded.name + ": " + why);
  settings_.auto_exposure = true;
}

/// Bakes ambient visibility at the scene's first display. If that fails, reports it and continues without.
void WindowLoop::add_visibility(std::uint32_t clip) {
  if (options_.occlusion_method != OcclusionMethod::rays) return;
  if (auto done = bake_missing_visibility(loaded_scenes_[scene_index_], {options_.key_poses, clip}, log_line); !done)
    log_line(done.error());
}

void WindowLoop::place_camera() {
  const LoadedScene& loaded = loaded_scenes_[scene_index_];
  const auto placed = options_.camera ? options_.camera : loaded.camera;
  camera_ = FramedCamera();
  camera_.orbit.fov_y_rad = options_.fov_y_deg ? *options_.fov_y_deg * std::numbers::pi / 180.0 : loaded.fov_y_rad;
  camera_is_framed_ = false;
  if (placed && settings_.framing == Framing::clip)
    camera_.orbit.place(placed->eye, placed->target);
  else
    frame_all();
}

void WindowLoop::frame_all() {
  camera_.frame(settings_.framing, *shown_, aspect(), free_);
  camera_is_framed_ = true;
}

// Switches from one of the file's cameras to the user's camera, starting from the same view.
void WindowLoop::leave_file_camera() {
  if (settings_.camera == kNone) return;
  camera_.orbit.take_over(shown_->view_of(settings_.camera, aspect()), shown_->bounds().reached);
  settings_.camera = kNone;
}

double WindowLoop::aspect() const {
  const VkExtent2D size = swapchain_.extent();
  return size.height == 0 ? 1.0 : static_cast<double>(size.width) / size.height;
}

// Requests the pose of the next picture; meshes out of view are culled.
void WindowLoop::request_next_pose() {
  camera_.follow(*shown_, aspect());
  const bool of_file = settings_.camera != kNone;
  const View view =
      of_file ? shown_->coming_view_of(settings_.camera, aspect()) : camera_.orbit.view(shown_->bounds().reached);
  shown_->set_cache_weight(settings_.cache_weight);
  shown_->set_shadows(settings_.shadows);
  shown_->submit(view, of_file && shown_->is_moved(settings_.camera), aspect(), settings_.needs_joints());
}

void WindowLoop::react(const Input& input) {
  if (input.any) frames_to_draw_ = kFramesAfterChange;
  if (!panel_.wants_keys())
    for (const int key : input.keys)
      if (const auto action = action_of_key(key)) act(*action);
  if (panel_.wants_mouse()) return;
  const double height = swapchain_.extent().height;
  const bool turns = input.turned != glm::dvec2(0.0), moves = input.moved != glm::dvec2(0.0);
  if (turns || moves || input.wheel != 0.0) {
    leave_file_camera();
    camera_is_framed_ = false;
  }
  if (turns) camera_.orbit.orbit(input.turned.x, input.turned.y, height);
  if (moves) camera_.orbit.pan(input.moved.x, input.moved.y, height);
  if (input.wheel != 0.0) camera_.orbit.zoom(input.wheel);
}

void WindowLoop::act(Action action) {
  if (apply(action, settings_) || apply(action, shown_->playback())) return;
  switch (action) {
    case Action::frame_all:
      leave_file_camera();
      frame_all();
      break;
    case Action::next_scene:
      requested_scene_ = (scene_index_ + 1) % static_cast<std::uint32_t>(loaded_scenes_.size());
      break;
    case Action::quit: window_.close(); break;
    default: break;
  }
}

// Adapts the swapchain to the window's size. Returns false while the window has no area.
bool WindowLoop::fit_swapchain() {
  const VkExtent2D size = window_.framebuffer_size();
  if (size.width == 0 || size.height == 0) return false;
  if (!swapchain_.fits(size)) {
    swapchain_.remake(size);
    panel_.follow(swapchain_);
    frames_to_draw_ = kFramesAfterChange;
  }
  return swapchain_.image_count() != 0;
}

PanelFacts WindowLoop::facts() {
  const LoadedScene& loaded = loaded_scenes_[scene_index_];
  PanelFacts facts;
  facts.name = loaded.name;
  facts.note = loaded.note;
  facts.reload_fault = reload_fault_;
  facts.device = device_.name();
  facts.scene = &loaded.scene;
  facts.needs = &shown_->needs();
  facts.cache = shown_->cache_facts();
  facts.updates = shown_->update_levels().reason();
  facts.rows = live_plan_.rows();
  facts.has_visibility = loaded.visibility != nullptr;
  facts.resting = shown_->resting();
  facts.frame_ms = frame_ms_;
  facts.scene_names = names_;
  facts.scene_index = scene_index_;
  return facts;
}

void WindowLoop::draw() {
  const ClipExtent& bounds = shown_->bounds();
  const View view =
      settings_.camera == kNone ? camera_.orbit.view(bounds.reached) : shown_->view_of(settings_.camera, aspect());
  const RenderOptions look = render_options(settings_, shown_->loaded().environment, bounds, eye_of(view));
  const bool drawn = frame_.draw(*shown_, view, look, settings_, [&] {
    const PanelRequests requests = lay_out_panel(facts(), settings_, shown_->playback());
    const bool room_changed = requests.free != free_;
    free_ = requests.free;
    if (room_changed && camera_is_framed_) frame_all();
    if (requests.frame_all) act(Action::frame_all);
    if (requests.scene) requested_scene_ = requests.scene;
  });
  if (!drawn) return;
  if (settings_.shows_plan()) {
    live_plan_.updates(shown_->update_levels());
    live_plan_.evaluated(shown_->stages(), shown_->newest(), shown_->resting());
    if (const auto cache = shown_->cache_facts()) live_plan_.cache(*cache, shown_->newest().work);
    live_plan_.drawn(shown_->upload_counts(), frame_.report(), frame_.pass_times());
    live_plan_.presented(frame_.window_times());
  }
  --frames_to_draw_;
  const double passed_ms = 1000.0 * seconds_since(last_picture_);
  last_picture_ = Clock::now();
  frame_ms_ += (passed_ms < 1000.0 ? 0.1 : 0.0) *
               (passed_ms - frame_ms_);  // a second without a picture counts as a pause, not as a slow frame
}

// Applies requests that cannot be applied during a frame: another scene, or a new plan after changed settings.
void WindowLoop::apply_requested_changes() {
  if (requested_scene_ && *requested_scene_ != scene_index_)
    switch_scene(*requested_scene_, std::nullopt, std::nullopt);
  requested_scene_.reset();
  if (settings_.evaluation() == shown_->evaluation()) return;
  shown_->stop();  // the job thread must not read the scene while centers of rotation are added
  add_missing_centers(loaded_scenes_[scene_index_], settings_.skinning);
  shown_->plan_for(settings_.evaluation());
  live_plan_.forget();
}

void WindowLoop::limit_frame_rate() {
  next_frame_ += std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(kFramePeriod_s));
  const auto now = Clock::now();
  if (next_frame_ > now)
    std::this_thread::sleep_until(next_frame_);
  else
    next_frame_ = now;
}

int WindowLoop::run() {
  if (const std::string missing = describe_missing_filter(options_.filter, device_.max_anisotropy()); !missing.empty())
    log_line(missing);
  const auto start = Clock::now();
  while (!window_.should_close()) {
    react(window_.poll(frames_to_draw_ > 0 ? 0.0 : kIdleWait_s));
    if (options_.exit_after_s && seconds_since(start) >= *options_.exit_after_s) break;
    shown_->playback().advance(std::min(seconds_since(last_look_), kLongestStep_s));
    last_look_ = Clock::now();
    apply_requested_changes();
    if (watch_ != nullptr) follow_file(seconds_since(start));
    if (!fit_swapchain()) {
      frames_to_draw_ = 0;  // minimised: only wait for events
      continue;
    }
    request_next_pose();
    report_error_once();
    if (!shown_->settled()) frames_to_draw_ = kFramesAfterChange;
    if (frames_to_draw_ <= 0) continue;
    draw();
    limit_frame_rate();
  }
  device_.wait_idle();
  const int code = exit_code_after_validation(options_, device_);
  return code == 0 && !reported_error_.empty() ? 1 : code;
}

// Reports once why the geometry cache cannot be shown. The window continues with the pose.
void WindowLoop::report_error_once() {
  if (shown_->cache_fault().empty() || shown_->cache_fault() == reported_error_) return;
  reported_error_ = shown_->cache_fault();
  log_line(reported_error_);
}

// Starts reloads of changed files and shows their result. If a reload fails, the old scene stays.
void WindowLoop::follow_file(double now_s) {
  watch_->look(now_s, [this] { return make_reload_job(options_, loaded_scenes_[scene_index_], *shown_); });
  auto read = watch_->take();
  if (!read) return;
  for (const std::string& line : read->messages) log_line(line);
  reload_fault_ = read->loaded ? show_changed(*std::move(read->loaded)) : read->loaded.error().message;
  log_line(reload_fault_.empty() ? loaded_scenes_[scene_index_].name + ": read again"
                                 : reload_fault_ + "; shown as before");
  frames_to_draw_ = kFramesAfterChange;
}

// Returns an error message if the changed scene cannot be shown; else an empty string.
std::string WindowLoop::show_changed(LoadedScene changed) {
  LoadedScene& loaded = loaded_scenes_[scene_index_];
  const auto camera = same_camera(loaded.scene, settings_.camera, changed.scene),
             variant = same_variant(loaded.scene, settings_.variant, changed.scene);
  if (!camera) leave_file_camera();
  const auto make = [this](const LoadedScene& made, const Evaluation& evaluation) {
    return make_shown(made, evaluation);
  };
  if (auto done = replace_shown_scene(device_, std::move(changed), loaded, shown_, make); !done) return done.error();
  settings_.camera = camera.value_or(kNone);
  settings_.variant = variant.value_or(kNone);
  live_plan_.forget();
  reported_error_.clear();
  camera_.keep_following(*shown_);
  return {};
}

}  // namespace

int run_window(const Options& options, std::vector<LoadedScene>& loaded_scenes, std::optional<std::uint32_t> clip,
               SceneReloader* watch) {
  WindowLoop loop(options, loaded_scenes, clip, watch);
  return loop.run();
}

}  // namespace sinew::viewer
