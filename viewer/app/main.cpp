// SPDX-License-Identifier: MIT
// sinew-viewer: shows a glTF file's animations in a window, or writes pictures of them.
#include <cstdio>
#include <functional>
#include <future>
#include <memory>
#include <new>
#include <optional>

#include <unistd.h>

#include "importer/file/cache_folder.h"
#include "viewer/app/bake_access.h"
#include "viewer/app/exhibit.h"
#include "viewer/app/headless_run.h"
#include "viewer/app/options.h"
#include "viewer/app/scene_choice.h"
#include "viewer/app/window_loop.h"
#include "viewer/device/device.h"

namespace sinew::viewer {
namespace {

void say(const std::string& line) { std::fprintf(stderr, "sinew-viewer: %s\n", line.c_str()); }

/// Shows the progress of `work`, if stderr is a terminal.
std::function<void(double)> progress_of(const char* work) {
  if (!isatty(STDERR_FILENO)) return nullptr;
  return [work](double done) {
    if (done < 1.0)
      std::fprintf(stderr, "\r%s: %3.0f %%", work, 100.0 * done);
    else
      std::fputs("\r\033[K", stderr);
  };
}

/// The device for pictures, made on a thread of its own: drivers take as long to load as files do.
std::future<std::unique_ptr<Device>> device_beside(const Options& options) {
  DeviceOptions wanted;
  wanted.validation = options.validate;
  wanted.disk_cache = options.disk_cache;
  return std::async(std::launch::async, [wanted] { return std::make_unique<Device>(wanted); });
}

int show(const Options& options) {
  std::future<std::unique_ptr<Device>> device;
  if (!options.headless.empty()) device = device_beside(options);
  std::optional<ExhibitWatch> watch;
  if (options.watch) watch.emplace(options.file);
  const auto progress = progress_of("reading");
  auto exhibits = load_exhibits(options, say, progress);
  if (progress) progress(1.0);
  if (!exhibits) {
    say(exhibits.error().message);
    return exhibits.error().exit_code;
  }
  const Scene& scene = (*exhibits)[options.first_exhibit()].scene;
  std::uint32_t clip = scene.animations.empty() ? kNone : 0;
  if (options.clip) {
    const auto chosen = choose_clip(scene, *options.clip);
    if (!chosen) {
      say(describe_missing_clip(scene, *options.clip));
      return 2;
    }
    clip = *chosen;
  }
  if (options.file_camera && !choose_camera(scene, *options.file_camera)) {
    say(describe_missing_camera(scene, *options.file_camera));
    return 2;
  }
  if (options.variant && !choose_variant(scene, *options.variant)) {
    say(describe_missing_variant(scene, *options.variant));
    return 2;
  }
  if (watch) watch->was_read(exhibits->front().files);
  if (options.headless.empty()) return run_window(options, *exhibits, clip, watch ? &*watch : nullptr);
  Exhibit& exhibit = (*exhibits)[options.first_exhibit()];
  add_missing_centers(exhibit, options.skinning, progress_of("centers of rotation"));
  if (options.occlusion_method == OcclusionMethod::rays) {
    const auto baked = add_missing_access(exhibit, {options.key_poses, clip}, say, progress_of("casting rays"));
    if (!baked) {
      say(baked.error());
      return 3;
    }
  }
  return write_pictures(*device.get(), options, exhibit, clip);
}

}  // namespace
}  // namespace sinew::viewer

int main(int argc, char** argv) {
  using namespace sinew::viewer;
  auto parsed = parse_options(argc, argv);
  if (const auto* leave = std::get_if<Leave>(&parsed)) {
    std::fputs(leave->text.c_str(), leave->code == 0 ? stdout : stderr);
    return leave->code;
  }
  try {
    auto& options = std::get<Options>(parsed);
    options.disk_cache = DiskCache(sinew::default_cache_folder());
    return show(options);
  } catch (const DeviceError& error) {
    say(error.what());
  } catch (const std::bad_alloc&) {
    say("out of memory");
  }
  return 3;
}
