// SPDX-License-Identifier: MIT
#include "viewer/app/loaded_scene.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "importer/add_centers_of_rotation.h"
#include "importer/import_gltf.h"
#include "runtime/model/scene.h"
#include "viewer/app/bake_visibility.h"
#include "viewer/app/open/asset_file_scene.h"
#include "viewer/app/open/vrm_facts.h"
#include "viewer/passes/frame_uniforms.h"
#include "viewer/upload/upload_materials.h"

namespace sinew::viewer {
namespace {

using LogLine = std::function<void(const std::string&)>;

/// Warns about material and texture extensions that would change the picture but are not supported.
void warn_about_unshown_extensions(const std::string& file, const std::vector<std::string>& extensions,
                                   const LogLine& log_line) {
  std::string names;
  for (const std::string& name : extensions) {
    const bool changes_pictures =
        name.find("_materials_") != std::string::npos || name.find("_texture_") != std::string::npos;
    if (changes_pictures && extension_support(name) != ExtensionSupport::read)
      names += (names.empty() ? "" : ", ") + name;
  }
  if (!names.empty()) log_line(file + ": warning: not shown: " + names);
}

/// Warns about scene content that exceeds the viewer's limits: lights, images of a material, texture coordinate sets.
void warn_about_unshown_content(const std::string& file, const Scene& scene, const LogLine& log_line) {
  if (scene.lights.size() > kMaxLights)
    log_line(file + ": warning: " + std::to_string(scene.lights.size()) + " lights; the viewer uses the first " +
             std::to_string(kMaxLights));
  for (const Material& material : scene.materials) {
    if (!shows_all_textures(material))
      log_line(file + ": warning: material \"" + material.name + "\" has more images than the viewer shows");
    for (const TextureUse* use : texture_uses(material))
      if (use->used() && use->texcoord > 1)
        log_line(file + ": warning: material \"" + material.name + "\" uses TEXCOORD_" + std::to_string(use->texcoord) +
                 "; the viewer takes TEXCOORD_0 instead");
  }
}

tl::unexpected<LoadError> fails(std::string why) { return tl::unexpected(LoadError{1, std::move(why)}); }

/// Selects one scene of a glTF file: the requested one, else the file's default scene, else all nodes.
tl::expected<void, LoadError> choose_scene(const std::string& file, std::optional<std::uint32_t> asked, Scene& scene,
                                           const LogLine& log_line) {
  const std::size_t count = scene.scenes.size();
  if (asked && *asked >= count)
    return tl::unexpected(LoadError{2, "--scene " + std::to_string(*asked) + ": " + file + " has " +
                                           (count == 0 ? "no scenes" : "scenes 0 to " + std::to_string(count - 1))});
  const std::uint32_t shown = asked.value_or(scene.default_scene);
  if (!asked && count > 1)
    log_line(file + ": " + std::to_string(count) + " scenes; scene " + std::to_string(shown) + " is shown (--scene)");
  show_scene(scene, shown);
  return {};
}

tl::expected<LoadedScene, LoadError> from_asset_file(const std::string& path, const LogLine& log_line) {
  auto scene = read_asset_file(path);
  if (!scene) return fails(std::move(scene.error()));
  warn_about_unshown_content(path, *scene, log_line);
  LoadedScene loaded;
  loaded.name = std::filesystem::path(path).filename().string();
  loaded.scene = *std::move(scene);
  loaded.files = {path};
  return loaded;
}

tl::expected<LoadedScene, LoadError> from_cache(const std::string& path) {
  auto file = open_cache_file(path);
  if (!file) return fails(std::move(file.error()));
  auto alone = show_cache_alone(std::move(*file));
  if (!alone) return fails(std::move(alone.error()));
  LoadedScene loaded;
  loaded.name = alone->cache->file.name;
  loaded.scene = std::move(alone->scene);
  loaded.cache = std::move(alone->cache);
  loaded.files = {path};
  return loaded;
}

tl::expected<LoadedScene, LoadError> from_gltf(const std::string& file, const Options& options, const LogLine& log_line,
                                               const std::function<void(double)>& progress) {
  ImportOptions import_options;
  const bool reads_visibility = options.occlusion_method == OcclusionMethod::rays && options.key_poses == 1;
  import_options.carry_document = reads_visibility;
  if (progress) import_options.progress = [&](const char*, double done) { progress(done); };
  auto imported = import_gltf(std::filesystem::path(file), import_options);
  if (!imported && reads_visibility) {  // a file with faulty animations can be shown; only its document is not whole
    import_options.carry_document = false;
    if (auto shown = import_gltf(std::filesystem::path(file), import_options)) imported = std::move(shown);
  }
  const auto& warnings = imported ? imported->warnings : imported.error().warnings;
  for (const auto& warning : warnings) log_line(describe(file, warning));
  if (!imported) return tl::unexpected(LoadError{1, describe(file, imported.error().issue)});
  warn_about_unshown_content(file, imported->scene, log_line);
  warn_about_unshown_extensions(file, imported->facts.extensions_used, log_line);
  if (auto chosen = choose_scene(file, options.scene, imported->scene, log_line); !chosen)
    return tl::unexpected(std::move(chosen.error()));
  LoadedScene loaded;
  if (imported->carried) loaded.visibility = file_visibility(*imported, log_line);
  loaded.name = std::filesystem::path(file).filename().string();
  loaded.scene = std::move(imported->scene);
  loaded.files = std::move(imported->facts.files);
  loaded.vrm = std::move(imported->vrm);
  if (loaded.vrm) {
    loaded.facing_yaw_rad = facing_yaw_rad(*loaded.vrm);
    loaded.note = describe_meta(*loaded.vrm);
  }
  return loaded;
}

}  // namespace

tl::expected<LoadedScene, LoadError> load_file(const std::string& file, const Options& options,
                                               const std::function<void(const std::string&)>& log_line,
                                               const std::function<void(double)>& progress) {
  std::vector<std::string> messages;
  const LogLine note = [&](const std::string& line) {
    messages.push_back(line);
    log_line(line);
  };
  auto loaded = is_cache_file(file)   ? from_cache(file)
                : is_asset_file(file) ? from_asset_file(file, note)
                                      : from_gltf(file, options, note, progress);
  if (loaded) loaded->messages = std::move(messages);
  return loaded;
}

tl::expected<void, LoadError> play_cache(const std::string& cache, LoadedScene& loaded,
                                         const std::function<void(const std::string&)>& log_line) {
  auto opened = open_cache_file(cache);
  if (!opened) return fails(std::move(opened.error()));
  auto bound = bind_cache(std::move(*opened), loaded.scene, log_line);
  if (!bound) return fails(std::move(bound.error()));
  loaded.cache = std::move(*bound);
  loaded.files.emplace_back(cache);
  return {};
}

Needs needs_of(const LoadedScene& loaded, const Evaluation& evaluation) {
  Needs needs;
  needs.out.local_pose = false;
  needs.out.bounds = true;
  needs.in.max_layers = 1;
  needs.skin.kind = evaluation.skinning;
  needs.skin.per_instance = loaded.instance_skinning;
  needs.out.stage_times = evaluation.stage_times || loaded.cache;
  if (loaded.cache) needs.in.cached_instances = loaded.cache->instances();
  needs.in.between_updates = evaluation.updates == Updates::interpolated;
  add_motion_needs(evaluation.motion, loaded.scene, loaded.rig.get(), needs);
  return needs;
}

std::vector<std::string> names_of(const std::vector<LoadedScene>& scenes) {
  std::vector<std::string> names;
  for (const LoadedScene& loaded : scenes) names.push_back(loaded.name);
  return names;
}

double cache_duration_s(const LoadedScene& loaded) noexcept { return loaded.cache ? loaded.cache->duration_s() : 0.0; }

void add_missing_centers(LoadedScene& loaded, Skinning skinning, const std::function<void(double)>& progress) {
  const auto& own = loaded.instance_skinning;
  const bool asked_for = own.empty() ? skinning == Skinning::center_of_rotation
                                     : std::find(own.begin(), own.end(), Skinning::center_of_rotation) != own.end();
  if (!asked_for) return;
  CentersOptions options;
  options.progress = progress;
  add_centers_of_rotation(loaded.scene, options);
}

}  // namespace sinew::viewer
