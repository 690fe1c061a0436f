// SPDX-License-Identifier: MIT
#include "viewer/app/exhibit.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "importer/add_centers_of_rotation.h"
#include "importer/import_gltf.h"
#include "runtime/base/contract.h"
#include "runtime/model/scene.h"
#include "samples/showcase/showcase.h"
#include "viewer/app/bake_access.h"
#include "viewer/app/load_environment.h"
#include "viewer/passes/frame_uniforms.h"
#include "viewer/upload/upload_materials.h"

namespace sinew::viewer {
namespace {

using Say = std::function<void(const std::string&)>;

std::vector<Exhibit> built_in(const Say& say) {
  std::vector<Exhibit> exhibits;
  for (auto& shown : showcase::showcase(showcase::flag_cache())) {
    auto& exhibit = exhibits.emplace_back();
    exhibit.name = std::move(shown.name);
    exhibit.note = std::move(shown.what_to_look_at);
    exhibit.scene = std::move(shown.scene);
    exhibit.instance_skinning = std::move(shown.needs.instance_skinning);
    exhibit.camera = PlacedCamera{shown.eye, shown.target};
    exhibit.fov_y_rad = static_cast<double>(shown.fov_y_rad);
    if (shown.geometry_cache.empty()) continue;
    auto file = open_cache_bytes("geometry cache, within the program", shown.geometry_cache);
    CONTRACT(file.has_value());
    exhibit.cache = *bind_cache(std::move(*file), exhibit.scene, say);
  }
  return exhibits;
}

/// Warns about extensions of materials and textures that would change the picture and are not shown.
void say_which_looks_are_left_out(const std::string& file, const std::vector<std::string>& extensions, const Say& say) {
  std::string names;
  for (const std::string& name : extensions) {
    const bool changes_pictures =
        name.find("_materials_") != std::string::npos || name.find("_texture_") != std::string::npos;
    if (changes_pictures && extension_support(name) != ExtensionSupport::read)
      names += (names.empty() ? "" : ", ") + name;
  }
  if (!names.empty()) say(file + ": warning: not shown: " + names);
}

/// Warns about what the scene has and the viewer does not show.
void say_what_is_left_out(const std::string& file, const Scene& scene, const Say& say) {
  if (scene.lights.size() > kMaxLights)
    say(file + ": warning: " + std::to_string(scene.lights.size()) + " lights; the viewer uses the first " +
        std::to_string(kMaxLights));
  for (const Material& material : scene.materials) {
    if (!shows_all_textures(material))
      say(file + ": warning: material \"" + material.name + "\" has more images than the viewer shows");
    for (const TextureUse* use : texture_uses(material))
      if (use->used() && use->texcoord > 1)
        say(file + ": warning: material \"" + material.name + "\" uses TEXCOORD_" + std::to_string(use->texcoord) +
            "; the viewer takes TEXCOORD_0 instead");
  }
}

tl::unexpected<LoadError> fails(std::string why) { return tl::unexpected(LoadError{1, std::move(why)}); }

/// Shows one scene of a file, as glTF says: the one that is asked for, else the file's default, else all of it.
tl::expected<void, LoadError> choose_scene(const std::string& file, std::optional<std::uint32_t> asked, Scene& scene,
                                           const Say& say) {
  const std::size_t count = scene.scenes.size();
  if (asked && *asked >= count)
    return tl::unexpected(LoadError{2, "--scene " + std::to_string(*asked) + ": " + file + " has " +
                                           (count == 0 ? "no scenes" : "scenes 0 to " + std::to_string(count - 1))});
  const std::uint32_t shown = asked.value_or(scene.default_scene);
  if (!asked && count > 1)
    say(file + ": " + std::to_string(count) + " scenes; scene " + std::to_string(shown) + " is shown (--scene)");
  show_scene(scene, shown);
  return {};
}

tl::expected<Exhibit, LoadError> from_cache(const std::string& path) {
  auto file = open_cache_file(path);
  if (!file) return fails(std::move(file.error()));
  auto alone = show_cache_alone(std::move(*file));
  if (!alone) return fails(std::move(alone.error()));
  Exhibit exhibit;
  exhibit.name = alone->cache->file.name;
  exhibit.scene = std::move(alone->scene);
  exhibit.cache = std::move(alone->cache);
  exhibit.files = {path};
  return exhibit;
}

tl::expected<Exhibit, LoadError> from_file(const Options& options, const Say& say,
                                           const std::function<void(double)>& progress) {
  const std::string &file = options.file, &cache = options.cache;
  ImportOptions how;
  const bool reads_access = options.occlusion_method == OcclusionMethod::rays && options.key_poses == 1;
  how.carry_document = reads_access;
  if (progress) how.progress = [&](const char*, double done) { progress(done); };
  auto imported = import_gltf(std::filesystem::path(file), how);
  const auto& warnings = imported ? imported->warnings : imported.error().warnings;
  for (const auto& warning : warnings) say(describe(file, warning));
  if (!imported) return tl::unexpected(LoadError{1, describe(file, imported.error().issue)});
  say_what_is_left_out(file, imported->scene, say);
  say_which_looks_are_left_out(file, imported->facts.extensions_used, say);
  if (auto chosen = choose_scene(file, options.scene, imported->scene, say); !chosen)
    return tl::unexpected(std::move(chosen.error()));
  Exhibit exhibit;
  if (reads_access) exhibit.access = access_of_file(*imported, say);
  exhibit.name = std::filesystem::path(file).filename().string();
  exhibit.scene = std::move(imported->scene);
  exhibit.files = std::move(imported->facts.files);
  if (cache.empty()) return exhibit;
  auto opened = open_cache_file(cache);
  if (!opened) return fails(std::move(opened.error()));
  auto bound = bind_cache(std::move(*opened), exhibit.scene, say);
  if (!bound) return fails(std::move(bound.error()));
  exhibit.cache = std::move(*bound);
  exhibit.files.emplace_back(cache);
  return exhibit;
}

tl::expected<Exhibit, LoadError> named_file(const Options& options, const Say& say,
                                            const std::function<void(double)>& progress) {
  const bool alone = is_cache_file(options.file);
  if (alone && !options.cache.empty())
    return tl::unexpected(LoadError{2, "--cache: " + options.file + " is a geometry cache itself"});
  if (alone && options.scene)
    return tl::unexpected(LoadError{2, "--scene: " + options.file + " is a geometry cache, which has no scenes"});
  return alone ? from_cache(options.file) : from_file(options, say, progress);
}

}  // namespace

Needs needs_of(const Exhibit& exhibit, const Evaluation& evaluation) {
  Needs needs;
  needs.bounds = true;
  needs.max_layers = 1;
  needs.skinning = evaluation.skinning;
  needs.instance_skinning = exhibit.instance_skinning;
  needs.stage_times = evaluation.stage_times || exhibit.cache;
  if (exhibit.cache) needs.cached_instances = exhibit.cache->instances();
  needs.between_updates = evaluation.updates == Updates::interpolated;
  return needs;
}

double cache_duration_s(const Exhibit& exhibit) noexcept { return exhibit.cache ? exhibit.cache->duration_s() : 0.0; }

tl::expected<std::vector<Exhibit>, LoadError> load_exhibits(const Options& options, const Say& say,
                                                            const std::function<void(double)>& progress) {
  std::vector<Exhibit> exhibits;
  if (options.file.empty()) {
    exhibits = built_in(say);
    if (options.first_exhibit() >= exhibits.size())
      return tl::unexpected(LoadError{2, "--scene " + std::to_string(options.first_exhibit()) +
                                             ": the built-in scenes are 0 to " + std::to_string(exhibits.size() - 1)});
  } else {
    auto exhibit = named_file(options, say, progress);
    if (!exhibit) return tl::unexpected(std::move(exhibit.error()));
    exhibits.push_back(std::move(*exhibit));
  }
  const auto environment = load_environment(options.environment, options.disk_cache);
  if (!environment) return fails(environment.error());
  for (Exhibit& exhibit : exhibits) exhibit.environment = *environment;
  return exhibits;
}

tl::expected<Exhibit, LoadError> reload_exhibit(const Options& options, std::shared_ptr<const Environment> environment,
                                                const Say& say) {
  auto exhibit = named_file(options, say, nullptr);
  if (exhibit) exhibit->environment = std::move(environment);
  return exhibit;
}

void add_missing_centers(Exhibit& exhibit, Skinning skinning, const std::function<void(double)>& progress) {
  const auto& own = exhibit.instance_skinning;
  const bool asked_for = own.empty() ? skinning == Skinning::center_of_rotation
                                     : std::find(own.begin(), own.end(), Skinning::center_of_rotation) != own.end();
  if (!asked_for) return;
  CentersOptions how;
  how.progress = progress;
  add_centers_of_rotation(exhibit.scene, how);
}

}  // namespace sinew::viewer
