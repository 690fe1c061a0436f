// SPDX-License-Identifier: MIT
#include "viewer/app/headless_run.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>

#include <unistd.h>

#include "runtime/assets/scene_look.h"
#include "runtime/base/contract.h"
#include "runtime/plan/run_plan.h"
#include "viewer/app/file_camera.h"
#include "viewer/app/headless.h"
#include "viewer/app/live_plan.h"
#include "viewer/app/orbit_camera.h"
#include "viewer/app/settings.h"
#include "viewer/app/sight.h"
#include "viewer/app/skeleton_lines.h"
#include "viewer/app/validation_outcome.h"

namespace sinew::viewer {
namespace {

namespace fs = std::filesystem;

// The pose of the exhibit at any time, evaluated where it is asked for.
class Poser {
 public:
  Poser(const Exhibit& exhibit, const Options& options, std::uint32_t clip)
      : clip_(clip), plan_(compile_plan(exhibit.scene, needs_of(exhibit, options.skinning, options.plan))), frame_(plan_) {}

  const Plan& plan() const noexcept { return plan_; }

  const FrameResult& at(double time_s, const Unseen& unseen, bool joints_watched) {
    const ClipLayer layer{clip_, time_s, 1.0f};
    FrameInput input;
    leave_out(unseen, joints_watched, input);
    if (clip_ != kNone) input.layers = {&layer, 1};
    const ErrorCode code = run_plan(plan_, input, frame_);
    CONTRACT(code == ErrorCode::ok);   // the clip is in range and the time is finite
    return frame_.result();
  }

 private:
  std::uint32_t clip_;
  Plan plan_;
  FrameBuffer frame_;
};

OrbitCamera camera_for(const Options& options, const Exhibit& exhibit, const ClipBounds& bounds) {
  OrbitCamera camera;
  camera.fov_y_rad = options.fov_y_deg ? *options.fov_y_deg * std::numbers::pi / 180.0 : exhibit.fov_y_rad;
  camera.frame(bounds.outline.points(), static_cast<double>(options.width) / options.height);
  return camera;
}

// A camera that was placed is taken as it is: an orbit camera cannot look straight down.
View view_for(const Options& options, const Exhibit& exhibit, const ClipBounds& bounds) {
  const OrbitCamera camera = camera_for(options, exhibit, bounds);
  const auto placed = options.camera ? options.camera : exhibit.camera;
  if (!placed) return camera.view(bounds.reached);
  const glm::dvec3 eye(placed->eye);
  return look_at(eye, placed->target, camera.fov_y_rad, near_plane_for(eye, bounds.reached));
}

// Pose, view and look of one command line, and the pictures of any time.
class PictureMaker {
 public:
  PictureMaker(Device& device, const Options& options, const Exhibit& exhibit, std::uint32_t clip)
      : exhibit_(exhibit),
        frame_look_(exhibit.scene),
        bounds_(clip_bounds(exhibit.scene, clip)),
        view_(view_for(options, exhibit, bounds_)),
        settings_(settings_from(options, exhibit.scene)),
        transparent_(options.transparent),
        watches_plan_(options.plan),
        aspect_(static_cast<double>(options.width) / options.height),
        poser_(exhibit, options, clip),
        unseen_(unseen_in(view_, clip)),
        skeleton_(exhibit.scene),
        headless_(device, exhibit.scene, options.width, options.height) {}

  Picture at(double time_s) {
    const FrameResult& pose = poser_.at(time_s, unseen_, settings_.watches_joints());
    if (settings_.camera != kNone) {
      apply_properties(exhibit_.scene, pose.properties, frame_look_);
      const Camera& camera = frame_look_.cameras[settings_.camera];
      view_ = view_of_camera(camera, pose.model[camera.joint], aspect_, bounds_.reached);
    }
    RenderOptions look = render_options(settings_, bounds_, eye_of(view_));
    look.transparent_background = transparent_;
    std::span<const LineVertex> lines;
    if (settings_.skeleton) lines = skeleton_.make(pose.model, skeleton_.axis_length_m(bounds_.largest));
    Picture picture = headless_.render(pose, view_, look, lines, settings_.variant);
    if (watches_plan_) {
      live_plan_.evaluated(poser_.plan(), pose);
      live_plan_.drawn(headless_.upload_counts(), headless_.report(), headless_.pass_times());
    }
    return picture;
  }

  const LivePlan& live_plan() const noexcept { return live_plan_; }

 private:
  /// A camera of the file may move with the pose: where it looks is known too late.
  Unseen unseen_in(const View& view, std::uint32_t clip) const {
    Sight sight(exhibit_.scene, poser_.plan().needs);
    return settings_.camera == kNone ? sight.of(clip, view, aspect_) : sight.nothing();
  }

  const Exhibit& exhibit_;
  SceneLook frame_look_;
  ClipBounds bounds_;
  View view_;
  Settings settings_;
  bool transparent_, watches_plan_;
  double aspect_;
  Poser poser_;
  Unseen unseen_;
  SkeletonLines skeleton_;
  Headless headless_;
  LivePlan live_plan_;
};

// Pictures that nobody keeps, so that a plan's times are not those of a first frame.
void warm_up(PictureMaker& maker, double duration_s) {
  constexpr std::uint32_t kPictures = 20;
  for (std::uint32_t n = 1; n <= kPictures; ++n) maker.at(duration_s * n / (kPictures + 1.0));
}

std::string picture_name(std::uint32_t picture) {
  const std::string digits = std::to_string(picture);
  return std::string(digits.size() < 5 ? 5 - digits.size() : 0, '0') + digits + ".png";
}

void show_progress(std::uint32_t done, std::uint32_t count) {
  if (count > 1 && isatty(STDERR_FILENO)) std::fprintf(stderr, done < count ? "\rpicture %u of %u" : "\r\033[K", done, count);
}

}  // namespace

double picture_time_s(std::uint32_t picture, double fps, double duration_s) noexcept {
  const double time = picture / fps;
  if (time <= duration_s || duration_s <= 0.0) return time;
  return std::fmod(time, duration_s);
}

int write_pictures(const Options& options, const Exhibit& exhibit, std::uint32_t clip) {
  if (options.frames) {
    std::error_code error;
    fs::create_directories(options.headless, error);
    if (error) {
      std::fprintf(stderr, "sinew-viewer: %s: %s\n", options.headless.c_str(), error.message().c_str());
      return 3;
    }
  }
  DeviceOptions wanted;
  wanted.validation = options.validate;
  Device device(wanted);
  PictureMaker maker(device, options, exhibit, clip);
  PngWriter writer;
  const double duration = clip == kNone ? 0.0 : exhibit.scene.animations[clip].duration_s;
  if (options.frames) {
    const auto [first, last] = *options.frames;
    for (std::uint32_t n = first;; ++n) {
      writer.write(fs::path(options.headless) / picture_name(n), maker.at(picture_time_s(n, options.fps, duration)));
      show_progress(n - first + 1, last - first + 1);
      if (n == last) break;
    }
  } else {
    const double time_s = options.time_s.value_or(0.0);
    if (options.plan) warm_up(maker, duration);
    writer.write(options.headless, maker.at(time_s));
  }
  if (options.plan) std::fputs(plan_text(maker.live_plan().rows()).c_str(), stdout);
  const auto failed = writer.finish();
  for (const auto& file : failed) std::fprintf(stderr, "sinew-viewer: %s\n", file.c_str());
  return failed.empty() ? exit_code_after_validation(options, device) : 3;
}

}  // namespace sinew::viewer
