// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "viewer/app/actions.h"
#include "viewer/app/camera/framed_camera.h"
#include "viewer/app/frame.h"
#include "viewer/app/frame_pace.h"
#include "viewer/app/live_plan.h"
#include "viewer/app/open/dropped_files.h"
#include "viewer/app/panel/panel.h"
#include "viewer/app/reload/scene_reloader.h"
#include "viewer/app/window.h"

namespace sinew::viewer {

/// The window with what it shows, from its first picture until the user closes it.
class WindowLoop {
 public:
  WindowLoop(const Options& options, std::vector<LoadedScene>& loaded_scenes, std::optional<std::uint32_t> clip,
             SceneReloader* watch);

  int run();

 private:
  using Clock = std::chrono::steady_clock;

  static constexpr int kFramesAfterChange = 4;  ///< frames drawn after input, because ImGui reacts over several frames

  /// The colours of a scene. Weights are those of a joint.
  struct Painted {
    Paint paint = Paint::materials;
    std::uint32_t joint = kNone;
    friend bool operator==(const Painted&, const Painted&) = default;
  };

  auto make_shown(const LoadedScene& loaded, const Evaluation& evaluation) {
    return std::make_unique<ShownScene>(device_, loaded, evaluation, Frame::kSlots, options_.filter);
  }
  void switch_scene(std::uint32_t index, std::optional<std::uint32_t> clip, std::optional<double> time_s);
  void repaint();
  void pick(const glm::dvec2& at);
  View view();
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
  void report_error_once();
  void follow_file(double now_s);
  std::string show_changed(LoadedScene changed);
  void show_dropped(DroppedFiles dropped);

  Options options_;  ///< with files dropped on the first scene
  std::vector<LoadedScene>& loaded_scenes_;
  SceneReloader* watch_;            ///< null = files are not reloaded
  std::vector<std::string> names_;  ///< of the scenes
  Window window_;
  Device device_;
  Swapchain swapchain_;
  PanelBackend panel_;
  Frame frame_;
  std::unique_ptr<LoadedScene> painted_;  ///< the shown scene in other colours; null = it is shown as it is
  Painted paint_;                         ///< of painted_
  std::unique_ptr<ShownScene> shown_;
  std::uint32_t scene_index_ = 0;
  FramedCamera camera_;
  FreePart free_;                  ///< part of the window beside the panel
  bool camera_is_framed_ = false;  ///< the user has not moved the camera since it framed the scene
  Settings settings_;
  bool exposure_is_adapted_ = false;  ///< adapt_to_light() has switched automatic exposure on
  LivePlan live_plan_;
  std::optional<std::uint32_t> requested_scene_;
  bool wants_screenshot_ = false;
  int frames_to_draw_ = kFramesAfterChange;  ///< before the loop pauses
  std::string reported_error_;
  FileDrop drop_;
  std::vector<std::string> drop_messages_, messages_;  ///< of the last drop; of the shown scene and the last drop
  std::string reload_fault_;                           ///< why the changed file is not shown; empty = it is
  Clock::time_point last_look_ = Clock::now();
  FramePace pace_{1.0 / 60.0};
};

/// Opens the window and plays until the user closes it.
/// in   clip   shown first; kNone = the rest pose; empty = the first clip
///      watch  reloads the scene when its files change; null = never
/// io   loaded_scenes  get centers of rotation when the user chooses that skinning method
/// out  exit code of the program: 0; 1 = a geometry cache is damaged; 3 = Options::validate is set and the validation
///      layer reported something
/// err  DeviceError if there is no display or no device
int run_window(const Options& options, std::vector<LoadedScene>& loaded_scenes, std::optional<std::uint32_t> clip,
               SceneReloader* watch);

}  // namespace sinew::viewer
