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
#include "viewer/app/bake_visibility.h"
#include "viewer/app/headless_run.h"
#include "viewer/app/inspect/paint.h"
#include "viewer/app/loaded_scene.h"
#include "viewer/app/log_line.h"
#include "viewer/app/open/open_files.h"
#include "viewer/app/options.h"
#include "viewer/app/scene_choice.h"
#include "viewer/app/window_loop.h"
#include "viewer/device/device.h"

namespace sinew::viewer {
namespace {

/// A callback that prints the progress of `work` on stderr; null if stderr is no terminal.
std::function<void(double)> progress_of(const char* work) {
  if (!isatty(STDERR_FILENO)) return nullptr;
  return [work](double done) {
    if (done < 1.0)
      std::fprintf(stderr, "\r%s: %3.0f %%", work, 100.0 * done);
    else
      std::fputs("\r\033[K", stderr);
  };
}

/// Creates the device on another thread while the file loads, because loading a driver takes about as long.
std::future<std::unique_ptr<Device>> make_device_async(const Options& options) {
  DeviceOptions wanted;
  wanted.validation = options.validate;
  wanted.disk_cache = options.disk_cache;
  return std::async(std::launch::async, [wanted] { return std::make_unique<Device>(wanted); });
}

/// Writes pictures of several evaluations side by side.
int compare(Device& device, const Options& options, std::vector<LoadedScene>& loaded_scenes, std::uint32_t clip) {
  const auto views = parse_views(options.compare, loaded_scenes.size());
  if (!views) {
    log_line("--compare: " + views.error());
    return 2;
  }
  for (const CompareView& view : *views) add_missing_centers(loaded_scenes.front(), view.skinning);
  return write_comparison(device, options, loaded_scenes, *views, clip);
}

int show(const Options& options) {
  std::future<std::unique_ptr<Device>> device;
  if (!options.headless.empty()) device = make_device_async(options);
  std::optional<SceneReloader> watch;
  if (options.watch) watch.emplace(options.file);
  const auto progress = progress_of("reading");
  auto loaded_scenes = load_scenes(options, log_line, progress);
  if (progress) progress(1.0);
  if (!loaded_scenes) {
    log_line(loaded_scenes.error().message);
    return loaded_scenes.error().exit_code;
  }
  const Scene& scene = (*loaded_scenes)[options.first_scene()].scene;
  std::uint32_t clip = scene.animations.empty() ? kNone : 0;
  if (options.clip) {
    const auto chosen = choose_clip(scene, *options.clip);
    if (!chosen) {
      log_line(describe_missing_clip(scene, *options.clip));
      return 2;
    }
    clip = *chosen;
  }
  if (loaded_scenes->front().rig && loaded_scenes->front().rig->graph) clip = kNone;
  if (const auto layers = find_layers(options.layers, scene); !layers) {
    log_line(layers.error());
    return 2;
  }
  if (options.file_camera && !choose_camera(scene, *options.file_camera)) {
    log_line(describe_missing_camera(scene, *options.file_camera));
    return 2;
  }
  if (options.joint && !choose_joint(scene, *options.joint)) {
    log_line(describe_missing_joint(scene, *options.joint));
    return 2;
  }
  if (options.variant && !choose_variant(scene, *options.variant)) {
    log_line(describe_missing_variant(scene, *options.variant));
    return 2;
  }
  if (watch) watch->was_read(loaded_scenes->front().files);
  if (options.headless.empty()) return run_window(options, *loaded_scenes, clip, watch ? &*watch : nullptr);
  LoadedScene& loaded = (*loaded_scenes)[options.first_scene()];
  add_missing_centers(loaded, options.skinning, progress_of("centers of rotation"));
  if (options.occlusion_method == OcclusionMethod::rays) {
    const auto baked =
        bake_missing_visibility(loaded, {options.key_poses, clip}, log_line, progress_of("casting rays"));
    if (!baked) {
      log_line(baked.error());
      return 3;
    }
  }
  const auto joint = options.joint ? choose_joint(loaded.scene, *options.joint) : std::nullopt;
  loaded.scene = painted(loaded.scene, options.inspected.paint, joint.value_or(kNone));
  if (!options.sheet.empty()) return write_sheet(*device.get(), options, loaded);
  if (!options.compare.empty()) return compare(*device.get(), options, *loaded_scenes, clip);
  return write_pictures(*device.get(), options, loaded, clip);
}

}  // namespace
}  // namespace sinew::viewer

int main(int argc, char** argv) {
  using namespace sinew::viewer;
  auto parsed = parse_options(argc, argv);
  if (const auto* leave = std::get_if<EarlyExit>(&parsed)) {
    std::fputs(leave->text.c_str(), leave->code == 0 ? stdout : stderr);
    return leave->code;
  }
  try {
    auto& options = std::get<Options>(parsed);
    options.disk_cache = DiskCache(sinew::default_cache_folder());
    return show(options);
  } catch (const DeviceError& error) {
    log_line(error.what());
  } catch (const std::bad_alloc&) {
    log_line("out of memory");
  }
  return 3;
}
