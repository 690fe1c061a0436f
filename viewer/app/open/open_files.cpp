// SPDX-License-Identifier: MIT
#include "viewer/app/open/open_files.h"

#include <utility>

#include "runtime/base/contract.h"
#include "samples/showcase/showcase.h"
#include "viewer/app/load_environment.h"
#include "viewer/app/motion/character_rig.h"
#include "viewer/app/open/add_clips.h"
#include "viewer/app/open/file_names.h"

namespace sinew::viewer {
namespace {

using LogLine = std::function<void(const std::string&)>;

std::vector<LoadedScene> built_in(const LogLine& log_line) {
  std::vector<LoadedScene> loaded_scenes;
  for (auto& shown : showcase::showcase(showcase::flag_cache())) {
    auto& loaded = loaded_scenes.emplace_back();
    loaded.name = std::move(shown.name);
    loaded.note = std::move(shown.what_to_look_at);
    loaded.scene = std::move(shown.scene);
    loaded.instance_skinning = std::move(shown.needs.skin.per_instance);
    loaded.camera = PlacedCamera{shown.eye, shown.target};
    loaded.fov_y_rad = static_cast<double>(shown.fov_y_rad);
    if (shown.geometry_cache.empty()) continue;
    auto file = open_cache_bytes("geometry cache, within the program", shown.geometry_cache);
    CONTRACT(file.has_value());
    loaded.cache = *bind_cache(std::move(*file), loaded.scene, log_line);
  }
  return loaded_scenes;
}

tl::unexpected<LoadError> refuses(int exit_code, std::string why) {
  return tl::unexpected(LoadError{exit_code, std::move(why)});
}

tl::expected<std::vector<LoadedScene>, LoadError> built_in_scenes(const Options& options, const LogLine& log_line) {
  std::vector<LoadedScene> scenes = built_in(log_line);
  if (options.first_scene() >= scenes.size())
    return refuses(2, "--scene " + std::to_string(options.first_scene()) + ": the built-in scenes are 0 to " +
                          std::to_string(scenes.size() - 1));
  return scenes;
}

/// Checks options that need a glTF file in the first place.
tl::expected<void, LoadError> check_first_file(const Options& options) {
  if (!is_cache_file(options.file)) return {};
  if (!options.cache.empty()) return refuses(2, "--cache: " + options.file + " is a geometry cache itself");
  if (options.scene) return refuses(2, "--scene: " + options.file + " is a geometry cache, which has no scenes");
  return {};
}

/// Opens the files of the command line. Files of --clips are clip files, even if they have something to draw.
tl::expected<std::vector<LoadedScene>, LoadError> scenes_of_files(const Options& options, const LogLine& log_line,
                                                                  const std::function<void(double)>& progress) {
  if (auto checked = check_first_file(options); !checked) return tl::unexpected(checked.error());
  std::vector<std::string> files{options.file};
  files.insert(files.end(), options.more_files.begin(), options.more_files.end());
  auto opened = open_files(expand_folders(files), options, log_line, progress);
  if (!opened) return tl::unexpected(std::move(opened.error()));
  if (!options.cache.empty()) opened->caches.push_back(options.cache);
  for (const std::string& file : options.clip_files) {
    Options plain = options;
    plain.scene.reset();
    auto clips = load_file(file, plain, log_line, nullptr);
    if (!clips) return tl::unexpected(std::move(clips.error()));
    if (clips->scene.animations.empty()) return refuses(1, "--clips: " + file + " has no clips");
    opened->clips.push_back(std::move(*clips));
  }
  auto scenes = combine_files(std::move(*opened), log_line);
  if (!scenes) return scenes;
  for (LoadedScene& loaded : *scenes)
    if (auto done = prepare_rig(loaded, options, &loaded == &scenes->front(), log_line); !done)
      return tl::unexpected(std::move(done.error()));
  return scenes;
}

}  // namespace

tl::expected<void, LoadError> prepare_rig(LoadedScene& loaded, const Options& options, bool takes_graph,
                                          const LogLine& log_line) {
  std::vector<std::string> left_out;
  CharacterRig rig = make_rig(loaded.scene, loaded.vrm.get(), left_out);
  for (const std::string& what : left_out) {
    loaded.messages.push_back(loaded.name + ": warning: left out: " + what);
    log_line(loaded.messages.back());
  }
  if (takes_graph && !options.graph.empty()) {
    auto graph = read_graph_for(options.graph, loaded.scene, rig.root, options.graph_script);
    if (!graph) return refuses(graph.error().starts_with("--set") ? 2 : 1, graph.error());
    rig.graph = *std::move(graph);
    const std::vector<std::string>& of_graph = rig.graph->source.files;
    loaded.files.insert(loaded.files.end(), of_graph.begin(), of_graph.end());
  }
  loaded.rig = std::make_shared<const CharacterRig>(std::move(rig));
  return {};
}

tl::expected<OpenedFiles, LoadError> open_files(const std::vector<std::string>& files, const Options& options,
                                                const LogLine& log_line, const std::function<void(double)>& progress) {
  if (files.empty()) return refuses(1, "the folder has no file that can be shown");
  OpenedFiles opened;
  Options own = options;
  for (std::size_t i = 0; i < files.size(); ++i) {
    if (names_panorama(files[i])) continue;  // of a folder: light is named on its own
    if (is_cache_file(files[i])) {
      opened.caches.push_back(files[i]);
      continue;
    }
    std::function<void(double)> part;
    if (progress)
      part = [&, i](double done) { progress((static_cast<double>(i) + done) / static_cast<double>(files.size())); };
    auto loaded = load_file(files[i], own, log_line, part);
    if (!loaded) return tl::unexpected(std::move(loaded.error()));
    own.scene.reset();  // it chooses a scene of the first file
    (is_clip_file(loaded->scene) ? opened.clips : opened.characters).push_back(std::move(*loaded));
  }
  return opened;
}

tl::expected<std::vector<LoadedScene>, LoadError> combine_files(OpenedFiles opened, const LogLine& log_line) {
  std::vector<LoadedScene> scenes = std::move(opened.characters);
  if (scenes.empty()) std::swap(scenes, opened.clips);
  for (LoadedScene& character : scenes)
    for (const LoadedScene& clips : opened.clips)
      add_clips(clips, character, [&](const std::string& line) {
        character.messages.push_back(line);
        log_line(line);
      });
  if (scenes.empty()) {
    for (const std::string& cache : opened.caches) {
      auto alone = load_file(cache, {}, log_line, nullptr);
      if (!alone) return tl::unexpected(std::move(alone.error()));
      scenes.push_back(std::move(*alone));
    }
    return scenes;
  }
  if (opened.caches.size() > 1)
    return refuses(2, "one geometry cache plays at a time; " + opened.caches[1] + " is another");
  if (!opened.caches.empty())
    if (auto done = play_cache(opened.caches.front(), scenes.front(), log_line); !done)
      return tl::unexpected(std::move(done.error()));
  return scenes;
}

tl::expected<std::vector<LoadedScene>, LoadError> load_scenes(const Options& options, const LogLine& log_line,
                                                              const std::function<void(double)>& progress) {
  auto scenes =
      options.file.empty() ? built_in_scenes(options, log_line) : scenes_of_files(options, log_line, progress);
  if (!scenes) return scenes;
  const auto environment = load_environment(options.environment, options.disk_cache);
  if (!environment) return refuses(1, environment.error());
  for (LoadedScene& loaded : *scenes) loaded.environment = *environment;
  return scenes;
}

tl::expected<LoadedScene, LoadError> reload_scene(const Options& options,
                                                  std::shared_ptr<const Environment> environment,
                                                  const LogLine& log_line) {
  auto scenes = scenes_of_files(options, log_line, nullptr);
  if (!scenes) return tl::unexpected(std::move(scenes.error()));
  scenes->front().environment = std::move(environment);
  return std::move(scenes->front());
}

}  // namespace sinew::viewer
