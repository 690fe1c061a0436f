// SPDX-License-Identifier: MIT
#include "viewer/app/window_loop.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "viewer/app/headless_run.h"
#include "viewer/app/inspect/pick.h"
#include "viewer/app/log_line.h"
#include "viewer/app/panel/joint_labels.h"
#include "viewer/app/panel/scene_facts.h"
#include "viewer/app/pictures/screenshot.h"
#include "viewer/app/validation_outcome.h"

namespace sinew::viewer {
namespace {

constexpr double kIdleWait_s = 0.1;      // longest wait for an event while nothing is animated
constexpr double kLongestStep_s = 0.25;  // of the animation, so that it does not jump after the machine was suspended

double seconds_since(std::chrono::steady_clock::time_point then) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - then).count();
}

DeviceOptions device_options(const Options& options, const Window& window) {
  DeviceOptions wanted;
  wanted.validation = options.validate;
  wanted.disk_cache = options.disk_cache;
  wanted.instance_extensions = window.instance_extensions();
  wanted.make_surface = [&window](VkInstance instance) { return window.make_surface(instance); };
  return wanted;
}

}  // namespace

WindowLoop::WindowLoop(const Options& options, std::vector<LoadedScene>& loaded_scenes,
                       std::optional<std::uint32_t> clip, SceneReloader* watch)
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
  switch_scene(options.first_scene(), clip, options.time_s);
}

// Looks at the vertex under the mouse, and at the joint that moves it most; at nothing beside the model.
void WindowLoop::pick(const glm::dvec2& at) {
  const Scene& scene = shown_->loaded().scene;
  const auto vertex = pick_vertex(scene, shown_->newest(), ray_through(view(), aspect(), at.x, at.y));
  settings_.inspected.vertex = vertex.value_or(VertexPlace{});
  if (!vertex) return;
  if (const auto influences = influences_of(scene, *vertex); !influences.empty())
    settings_.inspected.joint = influences.front().joint;
}

View WindowLoop::view() {
  return settings_.camera == kNone ? camera_.orbit.view(shown_->bounds().reached)
                                   : shown_->view_of(settings_.camera, aspect());
}

void WindowLoop::place_camera() {
  const LoadedScene& loaded = loaded_scenes_[scene_index_];
  const auto placed = options_.camera ? options_.camera : loaded.camera;
  camera_ = FramedCamera();
  camera_.orbit = opening_camera(loaded, options_);
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
  shown_->set_motion(settings_.motion);
  shown_->set_cache_weight(settings_.cache_weight);
  shown_->set_shadows(settings_.shadows);
  shown_->submit(view, of_file && shown_->is_moved(settings_.camera), aspect(), settings_.needs_joints());
}

void WindowLoop::react(const Input& input) {
  if (input.any) frames_to_draw_ = kFramesAfterChange;
  if (!input.dropped.empty()) drop_.add(input.dropped);
  if (!panel_.wants_keys())
    for (const int key : input.keys)
      if (const auto action = action_of_key(key)) act(*action);
  if (panel_.wants_mouse()) return;
  if (input.clicked && settings_.panel && settings_.inside) pick(*input.clicked);
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
    case Action::screenshot: wants_screenshot_ = true; break;
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
  PanelFacts facts = scene_facts(*shown_);
  messages_ = shown_->loaded().messages;
  messages_.insert(messages_.end(), drop_messages_.begin(), drop_messages_.end());
  facts.messages = messages_;
  facts.reload_fault = reload_fault_;
  facts.device = device_.name();
  facts.rows = live_plan_.rows();
  facts.frame_ms = pace_.picture_ms();
  facts.scene_names = names_;
  facts.scene_index = scene_index_;
  return facts;
}

void WindowLoop::draw() {
  const ClipExtent& bounds = shown_->bounds();
  const View view = this->view();
  const RenderOptions look = render_options(settings_, shown_->loaded().environment, bounds, eye_of(view));
  const bool drawn = frame_.draw(*shown_, view, look, settings_, [&] {
    if (settings_.skeleton) lay_out_joint_labels(shown_->loaded().scene, shown_->newest().model, view);
    const PanelRequests requests = lay_out_panel(facts(), settings_, shown_->playback());
    const bool room_changed = requests.free != free_;
    free_ = requests.free;
    if (room_changed) frames_to_draw_ = kFramesAfterChange;  // until the layout stands still
    if (room_changed && camera_is_framed_) frame_all();
    if (requests.frame_all) act(Action::frame_all);
    if (requests.scene) requested_scene_ = requests.scene;
  });
  if (!drawn) return;
  if (std::exchange(wants_screenshot_, false))
    log_line(write_screenshot(device_, *shown_, view, look, settings_, swapchain_.extent(), options_.filter));
  if (settings_.shows_plan()) {
    live_plan_.updates(shown_->update_levels());
    live_plan_.evaluated(shown_->stages(), shown_->newest(), shown_->resting());
    if (const auto cache = shown_->cache_facts()) live_plan_.cache(*cache, shown_->newest().work);
    live_plan_.drawn(shown_->upload_counts(), frame_.report(), frame_.pass_times());
    live_plan_.presented(frame_.window_times());
  }
  --frames_to_draw_;
  pace_.count_picture();
}

// Applies requests that cannot be applied during a frame: another scene, or a new plan after changed settings.
void WindowLoop::apply_requested_changes() {
  if (requested_scene_ && *requested_scene_ != scene_index_)
    switch_scene(*requested_scene_, std::nullopt, std::nullopt);
  requested_scene_.reset();
  repaint();
  if (settings_.evaluation(shown_->loaded().rig.get()) == shown_->evaluation()) return;
  shown_->stop();  // the job thread must not read the scene while centers of rotation are added
  add_missing_centers(painted_ ? *painted_ : loaded_scenes_[scene_index_], settings_.skinning);
  shown_->set_motion(settings_.motion);
  shown_->plan_for(settings_.evaluation(shown_->loaded().rig.get()));
  live_plan_.forget();
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
    if (auto dropped = drop_.follow(options_)) show_dropped(*std::move(dropped));
    if (!fit_swapchain()) {
      frames_to_draw_ = 0;  // minimised: only wait for events
      continue;
    }
    request_next_pose();
    report_error_once();
    if (!shown_->settled()) frames_to_draw_ = kFramesAfterChange;
    if (frames_to_draw_ <= 0) continue;
    draw();
    pace_.wait();
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

int run_window(const Options& options, std::vector<LoadedScene>& loaded_scenes, std::optional<std::uint32_t> clip,
               SceneReloader* watch) {
  WindowLoop loop(options, loaded_scenes, clip, watch);
  return loop.run();
}

}  // namespace sinew::viewer
