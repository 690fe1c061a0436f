// SPDX-License-Identifier: MIT
#include "viewer/app/headless_run.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>
#include <optional>

#include <unistd.h>

#include "viewer/app/adaptive_exposure.h"
#include "viewer/app/compare/picture_grid.h"
#include "viewer/app/log_line.h"
#include "viewer/app/pictures/film_writer.h"
#include "viewer/app/pictures/picture_maker.h"
#include "viewer/app/pictures/png_writer.h"
#include "viewer/app/scene_choice.h"
#include "viewer/app/validation_outcome.h"

namespace sinew::viewer {
namespace {

namespace fs = std::filesystem;

// Renders and discards pictures, so that the live plan shows steady-state times rather than first-frame times.
void warm_up(PictureMaker& maker, double duration_s) {
  constexpr std::uint32_t kPictures = 20;
  for (std::uint32_t n = 1; n <= kPictures; ++n) maker.at(duration_s * n / (kPictures + 1.0));
}

std::string picture_name(std::uint32_t picture) {
  const std::string digits = std::to_string(picture);
  return std::string(digits.size() < 5 ? 5 - digits.size() : 0, '0') + digits + ".png";
}

/// Tells on a terminal how many pictures are done, and about how long the others take.
class Progress {
 public:
  void show(std::uint32_t done, std::uint32_t count) const {
    if (count <= 1 || !isatty(STDERR_FILENO)) return;
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
    if (done < count)
      std::fprintf(stderr, "\rpicture %u of %u, %.0f s left\033[K", done, count,
                   passed.count() / done * (count - done));
    else
      std::fputs("\r\033[K", stderr);
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Takes the pictures of a command line: one file, numbered files in a folder, or a film.
class PictureFiles {
 public:
  explicit PictureFiles(const Options& options) : options_(options) {
    if (!options.film.empty()) film_.emplace(options.film, options.fps);
  }

  void write(std::uint32_t number, Picture picture) {
    if (film_)
      film_->write(picture);
    else if (options_.is_sequence())
      png_.write(fs::path(options_.headless) / picture_name(number), std::move(picture));
    else
      png_.write(options_.headless, std::move(picture));
  }

  /// Waits for all files; returns those that failed, with the reason.
  std::vector<std::string> finish() {
    std::vector<std::string> failed = png_.finish();
    if (film_)
      if (std::string why = film_->finish(); !why.empty()) failed.push_back(std::move(why));
    return failed;
  }

 private:
  const Options& options_;
  PngWriter png_;
  std::optional<FilmWriter> film_;
};

}  // namespace

double picture_time_s(std::uint32_t picture, double fps, double duration_s) noexcept {
  const double time = picture / fps;
  if (time <= duration_s || duration_s <= 0.0) return time;
  return std::fmod(time, duration_s);
}

namespace {

/// Renders and writes the requested pictures. Stops at the first picture that cannot show the geometry cache.
/// out  why it stopped, in one sentence; empty = all pictures were written
std::string make_pictures(const Options& options, double duration_s, PictureSource& source, PictureFiles& files) {
  const Progress progress;
  const double time_s = options.time_s.value_or(0.0);
  const auto time_of = [&](std::uint32_t n) { return picture_time_s(n, options.fps, duration_s); };
  const std::uint32_t first = options.frames ? options.frames->first : 0;
  const std::uint32_t count = options.frames ? options.frames->last - first + 1 : std::max(options.turntable, 1u);
  for (std::uint32_t i = 0; i < count; ++i) {
    const double turn = 2.0 * std::numbers::pi * i / count;
    Picture picture = options.frames ? source.in_sequence(first + i, time_of) : source.at(time_s, turn);
    if (!source.fault().empty()) return source.fault();
    files.write(first + i, std::move(picture));
    progress.show(i + 1, count);
  }
  return {};
}

double duration_of(const LoadedScene& loaded, std::uint32_t clip) {
  return std::max(clip == kNone ? 0.0 : loaded.scene.animations[clip].duration_s, cache_duration_s(loaded));
}

/// The options with exposure and texture filter that suit scene and device; says what is not as asked.
Options suited_options(Device& device, const Options& asked, const LoadedScene& loaded, std::uint32_t clip) {
  Options options = asked;
  if (const std::string why = adapt_exposure(device, asked, loaded, clip); !why.empty()) {
    log_line(loaded.name + ": " + why);
    options.auto_exposure = true;
  }
  if (const std::string missing = describe_missing_filter(options.filter, device.max_anisotropy()); !missing.empty())
    log_line(missing);
  return options;
}

/// Makes the folder of numbered pictures. Returns false, and says why, if that fails.
bool make_folder(const Options& options) {
  if (!options.is_sequence() || !options.film.empty()) return true;
  std::error_code error;
  fs::create_directories(options.headless, error);
  if (error) log_line(options.headless + ": " + error.message());
  return !error;
}

/// Waits for the files. Returns the exit code of the program.
int finish_files(const Options& options, Device& device, const std::string& fault, PictureFiles& files) {
  if (!fault.empty()) log_line(fault);
  const auto failed = files.finish();
  for (const auto& file : failed) log_line(file);
  if (!failed.empty()) return 3;
  return fault.empty() ? exit_code_after_validation(options, device) : 1;
}

}  // namespace

std::string adapt_exposure(Device& device, const Options& options, const LoadedScene& loaded, std::uint32_t clip) {
  if (!may_clip(options, loaded.scene)) return {};
  const double duration = duration_of(loaded, clip);
  const auto clipped = [&](bool automatic) {
    return clipped_share(
        PictureMaker(device, probe_options(options, automatic), loaded, clip).at(first_time_s(options, duration)));
  };
  const double given = clipped(false);
  return given <= kMostClipped ? std::string() : why_exposure_follows(given, clipped(true));
}

int write_pictures(Device& device, const Options& asked, const LoadedScene& loaded, std::uint32_t clip) {
  const Options options = suited_options(device, asked, loaded, clip);
  if (!make_folder(options)) return 3;
  PictureMaker maker(device, options, loaded, clip);
  const double duration = duration_of(loaded, clip);
  if (options.plan && !options.is_sequence()) warm_up(maker, duration);
  PictureFiles files(options);
  const std::string fault = make_pictures(options, duration, maker, files);
  if (options.plan) std::fputs(plan_text(maker.live_plan().rows()).c_str(), stdout);
  return finish_files(options, device, fault, files);
}

int write_comparison(Device& device, const Options& asked, const std::vector<LoadedScene>& loaded_scenes,
                     const std::vector<CompareView>& views, std::uint32_t clip) {
  const Options options = suited_options(device, asked, loaded_scenes.front(), clip);
  if (!make_folder(options)) return 3;
  const auto comparison = Comparison::make(device, options, loaded_scenes, views, clip);
  if (!comparison) {
    log_line(comparison.error());
    return 2;
  }
  PictureFiles files(options);
  const std::string fault = make_pictures(options, duration_of(loaded_scenes.front(), clip), **comparison, files);
  std::fputs(describe(**comparison).c_str(), stdout);
  return finish_files(options, device, fault, files);
}

int write_sheet(Device& device, const Options& asked, const LoadedScene& loaded) {
  constexpr std::uint32_t kPoses = 5;
  const auto clips = static_cast<std::uint32_t>(loaded.scene.animations.size());
  const Options options = suited_options(device, asked, loaded, clips == 0 ? kNone : 0);
  const Progress progress;
  std::vector<Picture> pictures;
  for (std::uint32_t clip = 0; clip < clips; ++clip) {
    PictureMaker maker(device, options, loaded, clip);
    const double duration = loaded.scene.animations[clip].duration_s;
    for (std::uint32_t pose = 0; pose < kPoses; ++pose) pictures.push_back(maker.at(duration * pose / (kPoses - 1)));
    std::printf("row %u: %s, %.3f s\n", clip + 1, clip_label(loaded.scene, clip).c_str(), duration);
    progress.show(clip + 1, clips);
  }
  if (pictures.empty()) pictures.push_back(PictureMaker(device, options, loaded, kNone).at(0.0));
  PictureFiles files(options);
  files.write(0, picture_grid(pictures, kPoses));
  return finish_files(options, device, {}, files);
}

}  // namespace sinew::viewer
