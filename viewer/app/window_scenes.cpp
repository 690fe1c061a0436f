// SPDX-License-Identifier: MIT
// The scenes of the window: shown, painted, read again and dropped.
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "viewer/app/bake_visibility.h"
#include "viewer/app/headless_run.h"
#include "viewer/app/inspect/paint.h"
#include "viewer/app/log_line.h"
#include "viewer/app/motion/layer_choice.h"
#include "viewer/app/reload/replace_shown_scene.h"
#include "viewer/app/scene_choice.h"
#include "viewer/app/window_loop.h"

namespace sinew::viewer {

void WindowLoop::switch_scene(std::uint32_t index, std::optional<std::uint32_t> clip, std::optional<double> time_s) {
  device_.wait_idle();
  if (index != scene_index_) settings_.leave_scene();
  scene_index_ = index;
  names_ = names_of(loaded_scenes_);
  shown_.reset();  // frees GPU memory before the next scene is uploaded
  painted_.reset();
  paint_ = {};
  add_missing_centers(loaded_scenes_[index], settings_.skinning);
  add_visibility(clip.value_or(loaded_scenes_[index].scene.animations.empty() ? kNone : 0));
  adapt_to_light(clip.value_or(loaded_scenes_[index].scene.animations.empty() ? kNone : 0));
  shown_ = make_shown(loaded_scenes_[index], settings_.evaluation(loaded_scenes_[index].rig.get()));
  shown_->set_motion(settings_.motion);
  live_plan_.forget();
  if (clip) shown_->playback().choose(*clip);
  if (time_s) shown_->playback().seek(*time_s);
  window_.set_title(loaded_scenes_[index].name + " - sinew");
  place_camera();
}

// Shows the scene in the colours that the settings ask for; playback continues.
void WindowLoop::repaint() {
  const Inspected& inspected = settings_.inspected;
  const Painted wanted{inspected.paint, inspected.paint == Paint::weights ? inspected.joint : kNone};
  if (wanted == paint_) return;
  const Playback before = shown_->playback();
  const Evaluation evaluation = shown_->evaluation();
  device_.wait_idle();
  shown_.reset();
  painted_.reset();
  paint_ = wanted;
  const LoadedScene& loaded = loaded_scenes_[scene_index_];
  if (wanted.paint != Paint::materials) {
    painted_ = std::make_unique<LoadedScene>(loaded);
    painted_->scene = painted(loaded.scene, wanted.paint, wanted.joint);
  }
  shown_ = make_shown(painted_ ? *painted_ : loaded, evaluation);
  shown_->set_motion(settings_.motion);
  shown_->playback().continue_from(before, before.clip());
  shown_->catch_up();
  live_plan_.forget();
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

// Starts reloads of changed files and shows their result. If a reload fails, the old scene stays.
void WindowLoop::follow_file(double now_s) {
  watch_->look(now_s, [this] { return make_reload_job(options_, loaded_scenes_.front(), *shown_); });
  auto read = watch_->take();
  if (!read) return;
  for (const std::string& line : read->messages) log_line(line);
  if (read->loaded && scene_index_ != 0)
    loaded_scenes_.front() = *std::move(read->loaded);  // it is shown when the user comes back to it
  else
    reload_fault_ = read->loaded ? show_changed(*std::move(read->loaded)) : read->loaded.error().message;
  log_line(reload_fault_.empty() ? loaded_scenes_.front().name + ": read again" : reload_fault_ + "; shown as before");
  frames_to_draw_ = kFramesAfterChange;
}

// Returns an error message if the changed scene cannot be shown; else an empty string.
std::string WindowLoop::show_changed(LoadedScene changed) {
  LoadedScene& loaded = loaded_scenes_[scene_index_];
  const auto camera = same_camera(loaded.scene, settings_.camera, changed.scene),
             variant = same_variant(loaded.scene, settings_.variant, changed.scene),
             joint = same_joint(loaded.scene, settings_.inspected.joint, changed.scene);
  if (!camera) leave_file_camera();
  const auto make = [this](const LoadedScene& made, const Evaluation& evaluation) {
    return make_shown(made, evaluation);
  };
  if (auto done = replace_shown_scene(device_, std::move(changed), loaded, shown_, make); !done) return done.error();
  settings_.camera = camera.value_or(kNone);
  settings_.variant = variant.value_or(kNone);
  settings_.inspected.joint = joint.value_or(kNone);
  settings_.inspected.vertex = {};
  painted_.reset();  // the changed scene is shown as it is, and painted in the next frame
  paint_ = {};
  keep_layers_of(loaded.scene, settings_.motion);
  live_plan_.forget();
  reported_error_.clear();
  camera_.keep_following(*shown_);
  return {};
}

// Shows what was dropped: new scenes, or the shown scene with more clips, a geometry cache or other light.
void WindowLoop::show_dropped(DroppedFiles dropped) {
  if (dropped.environment)
    for (LoadedScene& loaded : loaded_scenes_) loaded.environment = dropped.environment;
  DropOutcome outcome = apply_dropped(std::move(dropped), loaded_scenes_[scene_index_], options_);
  drop_messages_ = std::move(outcome.messages);
  if (scene_index_ == 0)
    options_.more_files.insert(options_.more_files.end(), outcome.added_files.begin(), outcome.added_files.end());
  if (outcome.changed)
    if (std::string why = show_changed(*std::move(outcome.changed)); !why.empty()) drop_messages_.push_back(why);
  if (outcome.new_clip && *outcome.new_clip < loaded_scenes_[scene_index_].scene.animations.size())
    shown_->playback().choose(*outcome.new_clip);
  for (const std::string& line : drop_messages_) log_line(line);
  frames_to_draw_ = kFramesAfterChange;
  if (outcome.new_scenes.empty()) return;
  const auto first_new = static_cast<std::uint32_t>(loaded_scenes_.size());
  device_.wait_idle();
  shown_.reset();  // it refers to a scene that moves in memory now
  const auto environment = loaded_scenes_[scene_index_].environment;
  for (LoadedScene& loaded : outcome.new_scenes) {
    loaded.environment = environment;
    loaded_scenes_.push_back(std::move(loaded));
  }
  switch_scene(first_new, std::nullopt, std::nullopt);
}

}  // namespace sinew::viewer
