// SPDX-License-Identifier: MIT
#include "viewer/app/headless_run.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <functional>
#include <numbers>
#include <optional>

#include <unistd.h>

#include "runtime/base/contract.h"
#include "runtime/plan/run_plan.h"
#include "viewer/app/adaptive_exposure.h"
#include "viewer/app/cache/cache_playback.h"
#include "viewer/app/camera_pose.h"
#include "viewer/app/frustum_culling.h"
#include "viewer/app/headless.h"
#include "viewer/app/live_plan.h"
#include "viewer/app/log_line.h"
#include "viewer/app/orbit_camera.h"
#include "viewer/app/png_writer.h"
#include "viewer/app/settings.h"
#include "viewer/app/skeleton_lines.h"
#include "viewer/app/validation_outcome.h"
#include "viewer/upload/visibility_blend.h"

namespace sinew::viewer {
namespace {

namespace fs = std::filesystem;

// Evaluates the scene's pose at any time, on the calling thread.
class PoseEvaluator {
 public:
  PoseEvaluator(const LoadedScene& loaded, const Evaluation& evaluation, std::uint32_t clip, float cache_weight)
      : clip_(clip),
        cache_weight_(cache_weight),
        plan_(compile_plan(lend(loaded.scene), needs_of(loaded, evaluation))),
        stages_(plan_.stages()),
        frame_(plan_),
        levels_(plan_, evaluation.updates) {
    if (loaded.cache) cache_.emplace(*loaded.cache, loaded.scene, CacheReader::Reads::blocking);
  }

  const Needs& needs() const noexcept { return plan_.needs(); }
  std::span<const PlanStage> stages() const noexcept { return stages_; }
  const FrameResult& newest() const noexcept { return frame_.result(); }
  UpdateLevels& levels() noexcept { return levels_; }
  const CachePlayback* cache() const noexcept { return cache_ ? &*cache_ : nullptr; }

  /// in   ahead_s  returns the clip time of the picture N frames after this one
  const FrameResult& at(double time_s, const std::function<double(std::uint32_t)>& ahead_s,
                        const CulledInstances& culled, bool joints_needed) {
    const ClipLayer layer{clip_, time_s, 1.0f}, ahead{clip_, ahead_s(levels_.frames_to_update()), 1.0f};
    const std::size_t count = clip_ != kNone;
    FrameInput now;
    apply_culling(culled, joints_needed, now);
    now.layers = {&layer, count};
    if (cache_) now.geometry = cache_->at(time_s, cache_weight_);
    const ErrorCode code = run_plan(plan_, levels_.input(now, {&ahead, count}), frame_);
    CONTRACT(code == ErrorCode::ok);  // the clip is in range and the time is finite
    if (cache_) cache_->watch(frame_.result());
    return frame_.result();
  }

 private:
  std::uint32_t clip_;
  float cache_weight_;
  Plan plan_;
  std::vector<PlanStage> stages_;
  FrameBuffer frame_;
  UpdateLevels levels_;
  std::optional<CachePlayback> cache_;
};

/// Time of the first picture.
double first_time_s(const Options& options, double duration_s) {
  return options.frames ? picture_time_s(options.frames->first, options.fps, duration_s) : options.time_s.value_or(0.0);
}

OrbitCamera camera_for(const Options& options, const LoadedScene& loaded, const Outline& outline) {
  OrbitCamera camera;
  camera.fov_y_rad = options.fov_y_deg ? *options.fov_y_deg * std::numbers::pi / 180.0 : loaded.fov_y_rad;
  camera.frame(outline.points(), static_cast<double>(options.width) / options.height);
  return camera;
}

/// Empty for Framing::clip, where the clip's own outline is framed.
std::optional<Framed> framed_for(const Options& options, const LoadedScene& loaded, std::uint32_t clip) {
  if (options.framing == Framing::clip) return std::nullopt;
  const double duration =
      std::max(clip == kNone ? 0.0 : loaded.scene.animations[clip].duration_s, cache_duration_s(loaded));
  return framed(options.framing, loaded.scene, clip, first_time_s(options, duration), loaded.cache.get());
}

// A placed camera bypasses OrbitCamera, which cannot look straight down.
View view_for(const Options& options, const LoadedScene& loaded, const ClipExtent& bounds, const OrbitCamera& camera) {
  const auto placed = options.camera ? options.camera : loaded.camera;
  if (!placed) return camera.view(bounds.reached);
  const glm::dvec3 eye(placed->eye);
  return look_at(eye, placed->target, camera.fov_y_rad, near_plane_for(eye, bounds.reached));
}

// Renders the pictures of one command line, at any time.
class PictureMaker {
 public:
  PictureMaker(Device& device, const Options& options, const LoadedScene& loaded, std::uint32_t clip)
      : clip_(clip),
        bounds_(clip_extent(loaded.scene, clip, loaded.cache.get())),
        framed_(framed_for(options, loaded, clip)),
        framing_(camera_for(options, loaded, framed_ ? framed_->outline : bounds_.outline)),
        view_(view_for(options, loaded, bounds_, framing_)),
        settings_(settings_from(options, loaded.scene)),
        environment_(loaded.environment),
        transparent_(options.transparent),
        shows_plan_(options.plan),
        frame_s_(1.0 / options.fps),
        aspect_(static_cast<double>(options.width) / options.height),
        evaluator_(loaded, {settings_.skinning, settings_.updates, options.plan}, clip, settings_.cache_weight),
        culling_(loaded.scene, evaluator_.needs(),
                 loaded.cache ? loaded.cache->reach(loaded.scene) : std::vector<Aabb>()),
        shadow_(shadow_sweep(loaded.scene, settings_.shadows, bounds_.reached, environment_.get())),
        skeleton_(loaded.scene),
        visibility_(loaded.visibility),
        headless_(device, loaded.scene, options.width, options.height, {}, visibility_.get(), options.filter) {
    if (settings_.camera != kNone) camera_.emplace(loaded.scene, settings_.camera);
  }

  /// Renders a single picture, evaluated exactly at its time.
  Picture at(double time_s) {
    evaluator_.levels().begin_exact_frame("one picture");
    return draw(time_s, [time_s](std::uint32_t) { return time_s; });
  }

  /// Renders picture number `picture` of a sequence; `time_of` returns the clip time of each number.
  Picture in_sequence(std::uint32_t picture, const std::function<double(std::uint32_t)>& time_of) {
    if (evaluator_.newest().frame == 0)
      evaluator_.levels().begin_exact_frame("the first picture");
    else if (evaluator_.cache() && settings_.cache_weight > 0.0f)
      evaluator_.levels().begin_exact_frame("a geometry cache plays");
    else if (camera_ && camera_->moves())
      evaluator_.levels().begin_exact_frame("the camera moves with the clip");
    else
      evaluator_.levels().begin_frame(size_in_picture(evaluator_.newest(), view_), frame_s_);
    return draw(time_of(picture), [&](std::uint32_t frames) { return time_of(picture + frames); });
  }

  const LivePlan& live_plan() const noexcept { return live_plan_; }

  /// One sentence if the last picture could not show the geometry cache; else empty.
  std::string fault() const { return evaluator_.cache() ? evaluator_.cache()->fault() : std::string(); }

 private:
  Picture draw(double time_s, const std::function<double(std::uint32_t)>& ahead_s) {
    if (camera_) view_ = camera_->at(clip_, time_s, aspect_, bounds_.reached);
    if (framed_) view_ = followed_view(time_s);
    const CulledInstances culled = culling_.of(clip_, view_, aspect_, shadow_);
    const FrameResult& pose = evaluator_.at(time_s, ahead_s, culled, settings_.needs_joints());
    RenderOptions look = render_options(settings_, environment_, bounds_, eye_of(view_));
    look.transparent_background = transparent_;
    std::span<const LineVertex> lines;
    if (settings_.skeleton) lines = skeleton_.make(pose.model, skeleton_.axis_length_m(bounds_.largest));
    Picture picture =
        headless_.render(pose, view_, look, lines, settings_.variant,
                         visibility_ ? visibility_blend(*visibility_, clip_, time_s) : VisibilityBlend{}, 1);
    if (shows_plan_) {
      live_plan_.updates(evaluator_.levels());
      live_plan_.evaluated(evaluator_.stages(), pose);
      if (evaluator_.cache()) live_plan_.cache(evaluator_.cache()->facts(), pose.work);
      live_plan_.drawn(headless_.upload_counts(), headless_.report(), headless_.pass_times());
    }
    return picture;
  }

  View followed_view(double time_s) const {
    OrbitCamera camera = framing_;
    camera.target += framed_->offset_at(time_s);
    return camera.view(bounds_.reached);
  }

  std::uint32_t clip_;
  ClipExtent bounds_;
  std::optional<Framed> framed_;  // unset = the whole clip is framed
  OrbitCamera framing_;
  View view_;
  Settings settings_;
  std::shared_ptr<const Environment> environment_;
  bool transparent_, shows_plan_;
  double frame_s_;  // time between pictures of a sequence
  double aspect_;
  PoseEvaluator evaluator_;
  FrustumCulling culling_;
  std::optional<glm::vec3> shadow_;
  std::optional<CameraPose> camera_;  // set if the picture is taken through one of the file's cameras
  SkeletonLines skeleton_;
  std::shared_ptr<const VertexVisibility> visibility_;
  Headless headless_;
  LivePlan live_plan_;
};

// Renders and discards pictures, so that the live plan shows steady-state times rather than first-frame times.
void warm_up(PictureMaker& maker, double duration_s) {
  constexpr std::uint32_t kPictures = 20;
  for (std::uint32_t n = 1; n <= kPictures; ++n) maker.at(duration_s * n / (kPictures + 1.0));
}

std::string picture_name(std::uint32_t picture) {
  const std::string digits = std::to_string(picture);
  return std::string(digits.size() < 5 ? 5 - digits.size() : 0, '0') + digits + ".png";
}

void show_progress(std::uint32_t done, std::uint32_t count) {
  if (count > 1 && isatty(STDERR_FILENO))
    std::fprintf(stderr, done < count ? "\rpicture %u of %u" : "\r\033[K", done, count);
}

}  // namespace

double picture_time_s(std::uint32_t picture, double fps, double duration_s) noexcept {
  const double time = picture / fps;
  if (time <= duration_s || duration_s <= 0.0) return time;
  return std::fmod(time, duration_s);
}

namespace {

/// Renders and writes the requested pictures. Stops at the first picture that cannot show the geometry cache.
/// out  why it stopped, in one sentence; empty = all pictures were written
std::string make_pictures(const Options& options, double duration_s, PictureMaker& maker, PngWriter& writer) {
  if (!options.frames) {
    if (options.plan) warm_up(maker, duration_s);
    Picture picture = maker.at(options.time_s.value_or(0.0));
    if (maker.fault().empty()) writer.write(options.headless, std::move(picture));
    return maker.fault();
  }
  const auto [first, last] = *options.frames;
  const auto time_of = [&](std::uint32_t n) { return picture_time_s(n, options.fps, duration_s); };
  for (std::uint32_t n = first;; ++n) {
    Picture picture = maker.in_sequence(n, time_of);
    if (!maker.fault().empty()) return maker.fault();
    writer.write(fs::path(options.headless) / picture_name(n), std::move(picture));
    show_progress(n - first + 1, last - first + 1);
    if (n == last) return {};
  }
}

}  // namespace

std::string adapt_exposure(Device& device, const Options& options, const LoadedScene& loaded, std::uint32_t clip) {
  if (!may_clip(options, loaded.scene)) return {};
  const double duration =
      std::max(clip == kNone ? 0.0 : loaded.scene.animations[clip].duration_s, cache_duration_s(loaded));
  const auto clipped = [&](bool automatic) {
    return clipped_share(
        PictureMaker(device, probe_options(options, automatic), loaded, clip).at(first_time_s(options, duration)));
  };
  const double given = clipped(false);
  return given <= kMostClipped ? std::string() : why_exposure_follows(given, clipped(true));
}

int write_pictures(Device& device, const Options& asked, const LoadedScene& loaded, std::uint32_t clip) {
  Options options = asked;
  if (const std::string why = adapt_exposure(device, asked, loaded, clip); !why.empty()) {
    log_line(loaded.name + ": " + why);
    options.auto_exposure = true;
  }
  if (options.frames) {
    std::error_code error;
    fs::create_directories(options.headless, error);
    if (error) {
      std::fprintf(stderr, "sinew-viewer: %s: %s\n", options.headless.c_str(), error.message().c_str());
      return 3;
    }
  }
  if (const std::string missing = describe_missing_filter(options.filter, device.max_anisotropy()); !missing.empty())
    std::fprintf(stderr, "sinew-viewer: %s\n", missing.c_str());
  PictureMaker maker(device, options, loaded, clip);
  PngWriter writer;
  const double duration =
      std::max(clip == kNone ? 0.0 : loaded.scene.animations[clip].duration_s, cache_duration_s(loaded));
  const std::string fault = make_pictures(options, duration, maker, writer);
  if (!fault.empty()) std::fprintf(stderr, "sinew-viewer: %s\n", fault.c_str());
  if (options.plan) std::fputs(plan_text(maker.live_plan().rows()).c_str(), stdout);
  const auto failed = writer.finish();
  for (const auto& file : failed) std::fprintf(stderr, "sinew-viewer: %s\n", file.c_str());
  if (!failed.empty()) return 3;
  return fault.empty() ? exit_code_after_validation(options, device) : 1;
}

}  // namespace sinew::viewer
