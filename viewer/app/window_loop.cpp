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
#include "viewer/app/bake_access.h"
#include "viewer/app/frame.h"
#include "viewer/app/framed_camera.h"
#include "viewer/app/live_plan.h"
#include "viewer/app/panel/panel.h"
#include "viewer/app/reload/go_over.h"
#include "viewer/app/scene_choice.h"
#include "viewer/app/validation_outcome.h"
#include "viewer/app/window.h"

namespace sinew::viewer {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double kFramePeriod_s = 1.0 / 60.0;  // a cap, because some drivers do not wait for the display
constexpr double kIdleWait_s = 0.1;            // longest wait for an event while nothing moves
constexpr double kLongestStep_s = 0.25;  // after the machine was suspended, the animation continues instead of jumping
constexpr int kFramesAfterChange = 4;    // ImGui reacts to input over a few frames

void say(const std::string& line) { std::fprintf(stderr, "sinew-viewer: %s\n", line.c_str()); }

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
  WindowLoop(const Options& options, std::vector<Exhibit>& exhibits, std::optional<std::uint32_t> clip,
             ExhibitWatch* watch)
      : options_(options),
        exhibits_(exhibits),
        watch_(watch),
        window_(options.width, options.height, "sinew"),
        device_(device_options(options, window_)),
        swapchain_(device_, window_.framebuffer_size()),
        panel_(device_, swapchain_, window_.handle()),
        frame_(device_, swapchain_, panel_),
        exhibit_(options.first_exhibit()),
        settings_(settings_from(options, exhibits[options.first_exhibit()].scene)) {
    if (!options.smooth_edges && device_.is_software())
      settings_.smooth_edges = false;  // it would take most of the time
    for (const auto& exhibit : exhibits) names_.push_back(exhibit.name);
    show_exhibit(options.first_exhibit(), clip, options.time_s);
  }

  int run();

 private:
  std::unique_ptr<ShownScene> make_shown(const Exhibit& exhibit, const Evaluation& evaluation) {
    return std::make_unique<ShownScene>(device_, exhibit, evaluation, Frame::kSlots, options_.filter);
  }
  void show_exhibit(std::uint32_t index, std::optional<std::uint32_t> clip, std::optional<double> time_s);
  void add_access(std::uint32_t clip);
  void place_camera();
  void frame_all();
  void leave_file_camera();
  double aspect() const;
  void ask();
  void react(const Input& input);
  void act(Action action);
  bool fit_swapchain();
  void grant_wishes();
  PanelFacts facts();
  void draw();
  void keep_pace();
  void say_fault();
  void follow_file(double now_s);
  std::string show_changed(Exhibit changed);

  const Options& options_;
  std::vector<Exhibit>& exhibits_;
  ExhibitWatch* watch_;  ///< null = files are read once
  std::vector<std::string> names_;
  Window window_;
  Device device_;
  Swapchain swapchain_;
  PanelBackend panel_;
  Frame frame_;
  std::unique_ptr<ShownScene> shown_;
  std::uint32_t exhibit_ = 0;
  FramedCamera camera_;
  FreeWidth free_;          ///< beside the panel
  bool as_framed_ = false;  ///< the user has not moved the camera since it framed the scene
  Settings settings_;
  LivePlan live_plan_;
  std::optional<std::uint32_t> wished_exhibit_;
  int frames_to_draw_ = kFramesAfterChange;  // before the loop stops drawing because nothing moves
  double frame_ms_ = 0.0;
  std::string said_fault_;
  std::string reload_fault_;  ///< why the changed file is not shown
  Clock::time_point last_look_ = Clock::now(), last_picture_ = last_look_, next_frame_ = last_look_;
};

void WindowLoop::show_exhibit(std::uint32_t index, std::optional<std::uint32_t> clip, std::optional<double> time_s) {
  device_.wait_idle();
  if (index != exhibit_) settings_.camera = settings_.variant = kNone;  // they belong to the last scene
  exhibit_ = index;
  shown_.reset();  // frees its memory before the next scene is uploaded
  add_missing_centers(exhibits_[index], settings_.skinning);
  add_access(clip.value_or(exhibits_[index].scene.animations.empty() ? kNone : 0));
  shown_ = make_shown(exhibits_[index], settings_.evaluation());
  live_plan_.forget();
  if (clip) shown_->playback().choose(*clip);
  if (time_s) shown_->playback().seek(*time_s);
  window_.set_title(exhibits_[index].name + " - sinew");
  place_camera();
}

/// Casts rays for an exhibit that is shown for the first time. The window goes on without where it cannot.
void WindowLoop::add_access(std::uint32_t clip) {
  if (options_.occlusion_method != OcclusionMethod::rays) return;
  if (auto done = add_missing_access(exhibits_[exhibit_], {options_.key_poses, clip}, say); !done) say(done.error());
}

void WindowLoop::place_camera() {
  const Exhibit& exhibit = exhibits_[exhibit_];
  const auto placed = options_.camera ? options_.camera : exhibit.camera;
  camera_ = FramedCamera();
  camera_.orbit.fov_y_rad = options_.fov_y_deg ? *options_.fov_y_deg * std::numbers::pi / 180.0 : exhibit.fov_y_rad;
  as_framed_ = false;
  if (placed && settings_.framing == Framing::clip)
    camera_.orbit.place(placed->eye, placed->target);
  else
    frame_all();
}

void WindowLoop::frame_all() {
  camera_.frame(settings_.framing, *shown_, aspect(), free_);
  as_framed_ = true;
}

// Continues from the view of the file's camera with the user's own camera.
void WindowLoop::leave_file_camera() {
  if (settings_.camera == kNone) return;
  camera_.orbit.take_over(shown_->view_of(settings_.camera, aspect()), shown_->bounds().reached);
  settings_.camera = kNone;
}

double WindowLoop::aspect() const {
  const VkExtent2D size = swapchain_.extent();
  return size.height == 0 ? 1.0 : static_cast<double>(size.width) / size.height;
}

// Requests the pose of the next picture, without what is out of view.
void WindowLoop::ask() {
  camera_.follow(*shown_, aspect());
  const bool of_file = settings_.camera != kNone;
  const View view =
      of_file ? shown_->coming_view_of(settings_.camera, aspect()) : camera_.orbit.view(shown_->bounds().reached);
  shown_->set_cache_weight(settings_.cache_weight);
  shown_->set_shadows(settings_.shadows);
  shown_->submit(view, of_file && shown_->is_moved(settings_.camera), aspect(), settings_.watches_joints());
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
    as_framed_ = false;
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
    case Action::next_scene: wished_exhibit_ = (exhibit_ + 1) % static_cast<std::uint32_t>(exhibits_.size()); break;
    case Action::quit: window_.close(); break;
    default: break;
  }
}

// Adapts the swapchain to the window. False while the window has no area.
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
  const Exhibit& exhibit = exhibits_[exhibit_];
  PanelFacts facts;
  facts.name = exhibit.name;
  facts.note = exhibit.note;
  facts.reload_fault = reload_fault_;
  facts.device = device_.name();
  facts.scene = &exhibit.scene;
  facts.needs = &shown_->needs();
  facts.cache = shown_->cache_facts();
  facts.updates = shown_->update_levels().reason();
  facts.rows = live_plan_.rows();
  facts.has_access = exhibit.access != nullptr;
  facts.resting = shown_->resting();
  facts.frame_ms = frame_ms_;
  facts.exhibits = names_;
  facts.exhibit = exhibit_;
  return facts;
}

void WindowLoop::draw() {
  const ClipExtent& bounds = shown_->bounds();
  const View view =
      settings_.camera == kNone ? camera_.orbit.view(bounds.reached) : shown_->view_of(settings_.camera, aspect());
  const RenderOptions look = render_options(settings_, shown_->exhibit().environment, bounds, eye_of(view));
  const bool drawn = frame_.draw(*shown_, view, look, settings_, [&] {
    const PanelWishes wishes = lay_out_panel(facts(), settings_, shown_->playback());
    const bool room_changed = wishes.free != free_;
    free_ = wishes.free;
    if (room_changed && as_framed_) frame_all();
    if (wishes.frame_all) act(Action::frame_all);
    if (wishes.exhibit) wished_exhibit_ = wishes.exhibit;
  });
  if (!drawn) return;
  if (settings_.watches_plan()) {
    live_plan_.updates(shown_->update_levels());
    live_plan_.evaluated(shown_->stages(), shown_->newest());
    if (const auto cache = shown_->cache_facts()) live_plan_.cache(*cache, shown_->newest().work);
    live_plan_.drawn(shown_->upload_counts(), frame_.report(), frame_.pass_times());
  }
  --frames_to_draw_;
  const double passed_ms = 1000.0 * seconds_since(last_picture_);
  last_picture_ = Clock::now();
  frame_ms_ += (passed_ms < 1000.0 ? 0.1 : 0.0) *
               (passed_ms - frame_ms_);  // a second without a picture was a pause, not a slow frame
}

// Does what the panel or a key asked for and what cannot be done within a frame.
void WindowLoop::grant_wishes() {
  if (wished_exhibit_ && *wished_exhibit_ != exhibit_) show_exhibit(*wished_exhibit_, std::nullopt, std::nullopt);
  wished_exhibit_.reset();
  if (settings_.evaluation() == shown_->evaluation()) return;
  shown_->stop();  // the job thread must not read the scene while it changes
  add_missing_centers(exhibits_[exhibit_], settings_.skinning);
  shown_->plan_for(settings_.evaluation());
  live_plan_.forget();
}

void WindowLoop::keep_pace() {
  next_frame_ += std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(kFramePeriod_s));
  const auto now = Clock::now();
  if (next_frame_ > now)
    std::this_thread::sleep_until(next_frame_);
  else
    next_frame_ = now;
}

int WindowLoop::run() {
  if (const std::string missing = describe_missing_filter(options_.filter, device_.max_anisotropy()); !missing.empty())
    say(missing);
  const auto start = Clock::now();
  while (!window_.should_close()) {
    react(window_.poll(frames_to_draw_ > 0 ? 0.0 : kIdleWait_s));
    if (options_.exit_after_s && seconds_since(start) >= *options_.exit_after_s) break;
    shown_->playback().advance(std::min(seconds_since(last_look_), kLongestStep_s));
    last_look_ = Clock::now();
    grant_wishes();
    if (watch_ != nullptr) follow_file(seconds_since(start));
    if (!fit_swapchain()) {
      frames_to_draw_ = 0;  // minimised: wait for an event
      continue;
    }
    ask();
    say_fault();
    if (!shown_->settled()) frames_to_draw_ = kFramesAfterChange;
    if (frames_to_draw_ <= 0) continue;
    draw();
    keep_pace();
  }
  device_.wait_idle();
  const int code = exit_code_after_validation(options_, device_);
  return code == 0 && !said_fault_.empty() ? 1 : code;
}

// Says once why a geometry cache cannot be shown; the window goes on with the pose.
void WindowLoop::say_fault() {
  if (shown_->cache_fault().empty() || shown_->cache_fault() == said_fault_) return;
  said_fault_ = shown_->cache_fault();
  say(said_fault_);
}

// Goes over to the file as it is now, once it is read. What cannot be shown leaves everything as it is.
void WindowLoop::follow_file(double now_s) {
  watch_->look(now_s, [this] { return reading(options_, exhibits_[exhibit_], *shown_); });
  auto read = watch_->take();
  if (!read) return;
  for (const std::string& line : read->said) say(line);
  reload_fault_ = read->exhibit ? show_changed(*std::move(read->exhibit)) : read->exhibit.error().message;
  say(reload_fault_.empty() ? exhibits_[exhibit_].name + ": read again" : reload_fault_ + "; shown as before");
  frames_to_draw_ = kFramesAfterChange;
}

// Answers why it cannot be shown; nothing when it is.
std::string WindowLoop::show_changed(Exhibit changed) {
  Exhibit& exhibit = exhibits_[exhibit_];
  const auto camera = same_camera(exhibit.scene, settings_.camera, changed.scene),
             variant = same_variant(exhibit.scene, settings_.variant, changed.scene);
  if (!camera) leave_file_camera();
  const auto make = [this](const Exhibit& made, const Evaluation& evaluation) { return make_shown(made, evaluation); };
  if (auto done = go_over(device_, std::move(changed), exhibit, shown_, make); !done) return done.error();
  settings_.camera = camera.value_or(kNone);
  settings_.variant = variant.value_or(kNone);
  live_plan_.forget();
  said_fault_.clear();
  camera_.go_on(*shown_);
  return {};
}

}  // namespace

int run_window(const Options& options, std::vector<Exhibit>& exhibits, std::optional<std::uint32_t> clip,
               ExhibitWatch* watch) {
  WindowLoop loop(options, exhibits, clip, watch);
  return loop.run();
}

}  // namespace sinew::viewer
